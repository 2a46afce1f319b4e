#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace frond {

/// SHA-256 (FIPS 180-4) of a text as lower-case hex: long words are known by it.
inline std::string sha256(std::string_view text) {
  // The first 32 bits of the fractional parts of cube and square roots of primes, found by exact search.
  auto root_bits = [](std::uint64_t prime, int power) {
    auto raised = [&](unsigned __int128 x) { return power == 2 ? x * x : x * x * x; };
    unsigned __int128 low = 0, high = 1ull << 40;  // root * 2^32
    // power 2: x^2 <= p * 2^64; power 3: x^3 <= p * 2^96
    unsigned __int128 bound = static_cast<unsigned __int128>(prime) << (power * 32);
    while (high - low > 1) {
      unsigned __int128 middle = (low + high) / 2;
      if (raised(middle) <= bound)
        low = middle;
      else
        high = middle;
    }
    return static_cast<std::uint32_t>(low);
  };
  std::array<std::uint32_t, 64> k{};
  std::array<std::uint32_t, 8> h{};
  std::size_t found = 0;
  for (std::uint64_t n = 2; found < 64; ++n) {
    bool prime = true;
    for (std::uint64_t d = 2; d * d <= n; ++d) prime &= n % d != 0;
    if (!prime) continue;
    if (found < 8) h[found] = root_bits(n, 2);
    k[found++] = root_bits(n, 3);
  }
  std::string data(text);
  data += '\x80';
  while (data.size() % 64 != 56) data += '\0';
  for (int i = 7; i >= 0; --i) data += static_cast<char>((text.size() * 8) >> (8 * i));
  for (std::size_t block = 0; block < data.size(); block += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
      w[i / 4 % 16] = w[i / 4 % 16] << 8 | static_cast<unsigned char>(data[block + i]);
    for (std::size_t i = 16; i < 64; ++i) {
      std::uint32_t a = w[i - 15], b = w[i - 2];
      w[i] = w[i - 16] + w[i - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) +
             (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
    }
    std::array<std::uint32_t, 8> v = h;
    for (std::size_t i = 0; i < 64; ++i) {
      std::uint32_t s1 = std::rotr(v[4], 6) ^ std::rotr(v[4], 11) ^ std::rotr(v[4], 25);
      std::uint32_t t1 = v[7] + s1 + ((v[4] & v[5]) ^ (~v[4] & v[6])) + k[i] + w[i];
      std::uint32_t s0 = std::rotr(v[0], 2) ^ std::rotr(v[0], 13) ^ std::rotr(v[0], 22);
      std::uint32_t t2 = s0 + ((v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]));
      v = {t1 + t2, v[0], v[1], v[2], v[3] + t1, v[4], v[5], v[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) h[i] += v[i];
  }
  std::string hex;
  for (std::uint32_t word : h)
    for (int i = 28; i >= 0; i -= 4) hex += "0123456789abcdef"[word >> i & 15];
  return hex;
}

}  // namespace frond
