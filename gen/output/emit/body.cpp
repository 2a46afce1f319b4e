#include <algorithm>
#include <array>
#include <numeric>

#include "core/seed.h"
#include "emit/branch_materials.h"
#include "field/cubes.h"

namespace frond {

namespace {

constexpr std::size_t kPartTriangles = 10'000;  // POV-Ray reads many meshes faster than one large one

/// The numbers of a list, each once and in order, and where in it one is.
struct Numbers {
  std::vector<std::uint32_t> all;

  explicit Numbers(std::vector<std::uint32_t> list) : all(std::move(list)) {
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
  }
  std::uint32_t place_of(std::uint32_t number) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(all, number) - all.begin());
  }
};

/// Some triangles of a surface, each corner with the number of its texture in a list.
struct Part {
  std::vector<std::array<std::uint32_t, 3>> triangles, textures;
  std::vector<std::string> list;
};

/// Appends a mesh2 of a part; without a list it has no texture.
void append_part(ObjectText& all, const PovSpace& space, const Surface& surface, const Part& part) {
  std::string& text = all.text;
  ++all.objects;
  std::vector<std::uint32_t> corners;
  for (const auto& t : part.triangles) corners.insert(corners.end(), t.begin(), t.end());
  Numbers used(std::move(corners));
  text += "mesh2{\n";
  append_items(text, "vertex_vectors", used.all,
               [&](std::uint32_t v) { append_point(text, space, surface.position[v]); });
  append_items(text, "normal_vectors", used.all, [&](std::uint32_t v) {
    append_vector(text, 3, surface.normal[v].x, surface.normal[v].y, -surface.normal[v].z);
  });
  if (!part.list.empty())
    append_items(text, "texture_list", part.list, [&](const std::string& t) { text += t; });
  text += "face_indices{";
  append_index(text, part.triangles.size());
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    // The mirror turns triangles over, and this turns them back.
    auto [a, b, c] = part.triangles[i];
    text += ',';
    append_vector(text, 0, used.place_of(a), used.place_of(c), used.place_of(b));
    if (part.list.empty()) continue;
    auto [p, q, r] = part.textures[i];
    text += ',';
    if (p == q && q == r)
      append_index(text, p);
    else
      append_list(text, 0, p, r, q);
  }
  text += "}}\n";
}

/// The textures of chunks, each text once.
struct ChunkTextures {
  std::vector<std::uint32_t> of_node;  // number of the text
  std::vector<std::string> texts;
};

ChunkTextures chunk_textures(const PovSpace& space, const DrawnBranches& b, std::size_t skin) {
  ChunkTextures textures;
  textures.of_node.assign(b.rest().size(), 0);
  for (const Chunk& chunk : cut_chunks(b.rest(), b.pose, b.chunk_options())) {
    std::string text;
    append_chunk_texture(text, space, b, chunk, skin);
    if (textures.texts.empty() || textures.texts.back() != text) textures.texts.push_back(std::move(text));
    for (std::int32_t i = chunk.first; i <= chunk.last; ++i)
      textures.of_node[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(textures.texts.size() - 1);
  }
  return textures;
}

ObjectText fused_text(const PovSpace& space, const FusedMesh& mesh, const ChunkTextures& textures,
                      bool one_texture, std::size_t skin) {
  auto texture_of = [&](std::uint32_t v) { return textures.of_node[static_cast<std::size_t>(mesh.node[v])]; };
  // Triangles of one chunk together, so that a part has few textures.
  std::vector<std::uint32_t> order(mesh.surface.triangle.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {},
                           [&](std::uint32_t t) { return texture_of(mesh.surface.triangle[t][0]); });
  ObjectText text;
  for (std::size_t from = 0; from < order.size(); from += kPartTriangles) {
    Part part;
    std::vector<std::uint32_t> worn;
    std::size_t to = std::min(order.size(), from + kPartTriangles);
    for (std::size_t i = from; i < to; ++i) {
      part.triangles.push_back(mesh.surface.triangle[order[i]]);
      if (one_texture) continue;
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) worn.push_back(corners[k] = texture_of(part.triangles.back()[k]));
      part.textures.push_back(corners);
    }
    Numbers numbers(std::move(worn));
    for (std::uint32_t n : numbers.all) part.list.push_back(textures.texts[n]);
    for (auto& corners : part.textures)
      for (std::uint32_t& n : corners) n = numbers.place_of(n);
    append_part(text, space, mesh.surface, part);
  }
  if (!one_texture || text.objects == 0) return text;
  return {"union{\n" + text.text + skin_texture(skin) + "}\n", 1};
}

Result<ObjectText> cubes_text(const PovSpace& space, const DrawnBranches& b) {
  BranchVolume limbs = b.boughs();
  if (limbs.cones.empty()) return ObjectText();
  Result<Cubes> cubes = cubes_of(limbs, b.volume());
  if (!cubes) return cubes.errors();
  std::vector<std::uint32_t> cube;
  Surface surface = cubes_surface(*cubes, cube);
  double young = b.look().young_length();
  float longest = b.rest().longest();
  // The looks of cubes: colour of the bark, age and shade.
  std::size_t colors = b.look().colors();
  std::vector<std::uint32_t> look(cubes->size());
  std::vector<bool> used(colors * kCubeAges * kCubeShades);
  for (std::size_t c = 0; c < cubes->size(); ++c) {
    std::int32_t node = cubes->node[c];
    Cell cell = cubes->cell[c];
    std::uint64_t lot = Seed{block_key({cell.i * 8, cell.j * 8, cell.k * 8})}.bits();
    float age = youth(b.rest(), b.pose, longest, static_cast<float>(young), node);
    // Between two ages lots are drawn, so that one runs into the other.
    float level = age * (kCubeAges - 1) + static_cast<float>(Seed{lot}.unit()) * 0.999f;
    std::size_t color = b.look().color_at(b.model, node);
    look[c] = static_cast<std::uint32_t>((color * kCubeAges + static_cast<std::size_t>(level)) * kCubeShades +
                                         lot % kCubeShades);
    used[look[c]] = true;
  }
  std::vector<std::uint32_t> number(used.size());
  Part all;
  for (std::size_t l = 0; l < used.size(); ++l) {
    if (!used[l]) continue;
    number[l] = static_cast<std::uint32_t>(all.list.size());
    all.list.push_back(cube_texture(b.look(), l / (kCubeAges * kCubeShades), b.traits.brightness,
                                    b.traits.style.voxel, static_cast<int>(l / kCubeShades % kCubeAges),
                                    static_cast<int>(l % kCubeShades)));
  }
  ObjectText text;
  for (std::size_t from = 0; from < surface.triangle.size(); from += kPartTriangles) {
    Part part{{}, {}, all.list};
    for (std::size_t t = from; t < std::min(surface.triangle.size(), from + kPartTriangles); ++t) {
      std::uint32_t n = number[look[cube[t / 2]]];
      part.triangles.push_back(surface.triangle[t]);
      part.textures.push_back({n, n, n});
    }
    append_part(text, space, surface, part);
  }
  return text;
}

}  // namespace

Result<ObjectText> body_text(const PovSpace& space, const DrawnBranches& b, std::size_t skin) {
  if (b.traits.style.build == Build::voxels) return cubes_text(space, b);
  Result<FusedMesh> mesh = b.body();
  if (!mesh) return mesh.errors();
  return fused_text(space, *mesh, chunk_textures(space, b, skin), b.one_texture(), skin);
}

}  // namespace frond
