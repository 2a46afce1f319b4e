#pragma once

namespace frond {

/// What grows in a meadow. Sizes are shares of the length of its grass.
enum class MeadowPlant {
  grass,      ///< blades of middling width
  fescue,     ///< tufts of blades as fine as threads
  cocksfoot,  ///< clumps of long broad blades
  panicle,    ///< culms that stand above the rest and bear seed
  clover,     ///< leaves of three leaflets with a pale chevron, white heads here and there
  daisy,      ///< spoons that lie flat about a white head with a yellow heart
  buttercup,  ///< yellow cups on stalks above leaves of three lobes
  plantain,   ///< ribbed lances about a brown spike
};

/// How much of a meadow is of a kind.
struct Sward {
  MeadowPlant kind = MeadowPlant::grass;
  double share = 1;   ///< against the other shares
  double height = 1;  ///< factor of its size
};

}  // namespace frond
