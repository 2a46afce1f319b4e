#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "images/exr.h"

/// Masks of named things in an OpenEXR file, with soft edges, as compositing programs read them: Cryptomatte
/// (Friedman and Jones, "Fully automatic ID mattes with support for motion blur and transparency", 2015), by
/// version 1.2.0 of its specification.
namespace frond {

/// The 32 bits of MurmurHash3 (Appleby, 2011; x86, 32 bits) with seed 0.
std::uint32_t murmur_hash(std::string_view text);

/// The bits of the number that stands for a name in pixels and manifest: its hash, with one bit of the
/// exponent turned where it would be no common number.
std::uint32_t cryptomatte_id(std::string_view name);

/// How much of each pixel is covered by what: entries pixel by pixel, row by row from the top.
struct Coverages {
  struct Entry {
    std::uint32_t name = 0;  ///< an index of a list of names
    float share = 0;         ///< of the pixel, 0 to 1
  };
  std::vector<Entry> entries;
  std::vector<std::size_t> ends;  ///< a number per pixel: where its entries end, and those of the next begin
};

/// What becomes part of an OpenEXR file; several layers may be part of one.
struct Cryptomatte {
  std::vector<ExrChannel> channels;
  ExrAttributes attributes;
};

/// The channels LAYER00.R, G, B, A, LAYER01.R and so on: two pairs of an id and a share in each four, of the
/// `ranks` names that cover most of a pixel, those that cover more first; pairs that are left are 0. Equal
/// names, and names of one id, are one. The attributes name the layer and list the ids of all names.
Cryptomatte cryptomatte(const std::string& layer, std::span<const std::string> names,
                        const Coverages& coverages, int ranks = 6);

}  // namespace frond
