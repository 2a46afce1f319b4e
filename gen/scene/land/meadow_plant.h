#pragma once

namespace frond {

/// Plants of a meadow. Sizes are relative to the length of its grass.
enum class MeadowPlant {
  grass,      ///< blades of medium width
  fescue,     ///< tufts of blades as fine as threads
  cocksfoot,  ///< clumps of long broad blades
  panicle,    ///< culms with seed heads that stand above the rest
  clover,     ///< leaves of three leaflets with a pale chevron, white heads here and there
  daisy,      ///< spoons that lie flat about a white head with a yellow heart
  buttercup,  ///< yellow cups on stalks above leaves of three lobes
  plantain,   ///< ribbed lances about a brown spike
};

/// The share of one kind in a meadow.
struct Sward {
  MeadowPlant kind = MeadowPlant::grass;
  double share = 1;   ///< relative to the other shares
  double height = 1;  ///< factor of its size
};

}  // namespace frond
