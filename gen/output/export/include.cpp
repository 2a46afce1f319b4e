#include "export/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/bounds.h"
#include "core/content.h"
#include "emit/branch_materials.h"
#include "emit/copies.h"
#include "emit/setting.h"
#include "emit/solid.h"
#include "emit/worn.h"
#include "export/formats.h"
#include "export/macros.h"
#include "scene/copies.h"
#include "settings/settings.h"

namespace frond {

namespace {

/// The level of something so tall at a detail, by its grain: a five hundredth of it, then a hundred and
/// fiftieth.
int level_at(double height, int detail) {
  constexpr double kFinest = 0.002;  // metres
  return level_for(std::max(kFinest, height / 500 * std::pow(3.3, detail)));
}

Bounds box_of(const Specimen& specimen) {
  Bounds box;
  for (const CopyPart& part : copy_parts(specimen.look, specimen.model, {0.01, 2e5}))
    for (const Vec3& p : part.surface.position) box.extend(p);
  return box;
}

double tall_of(const CopySet& set) {
  double height = set.tallest();
  return height > 0 ? height : 8 * set.organism.sown->where.radius;
}

/// Writes the parts of an include, each a macro that is only read where a scene asks for it.
class Writer {
 public:
  Writer(const IncludeText& what, const std::vector<IncludeVariant>& variants)
      : what_(what), variants_(variants) {}

  Result<std::string> text() {
    for (std::size_t v = 0; v < variants_.size(); ++v)
      if (Errors errors = write_variant(v); !errors.empty()) return errors;
    return head() + macros_text(what_.macros, macros_used(what_.macros, shapes_)) + shapes_ + foot();
  }

 private:
  Errors write_variant(std::size_t v) {
    const IncludeVariant& variant = variants_[v];
    FrameParts parts = prepare_frames(variant.scene, {}, false);
    std::vector<double> heights;
    for (const Specimen& b : variant.scene.specimens) {
      Bounds own = box_of(b);
      heights.push_back(std::max(0.0f, own.size().y));
      box_.extend(own);
    }
    for (const CopySet& set : variant.scene.copy_sets)
      for (std::size_t i = 0; i < set.copies.size(); ++i) {
        auto wide = static_cast<float>(set.organism.sown->where.radius);
        box_.extend(set.copies.foot[i] + Vec3(-wide, 0, -wide));
        box_.extend(set.copies.foot[i] + Vec3(wide, tall_of(set), wide));
      }
    shapes_ += fmt::format("#macro {}_Parts_{}()\n#local Frond_Unit = {};\n", what_.name, v,
                           number_text(parts.space.unit));
    shapes_ += parts.materials + "#end\n";
    ObjectText solids = solids_text(parts.space, variant.scene);
    shapes_ += fmt::format("#macro {}_Solids_{}()\n{}#end\n", what_.name, v, solids.text);
    solids_ = solids.objects;
    for (int detail = 0; detail < kIncludeDetails; ++detail) {
      const CopyPlan& plan = variant.plans[static_cast<std::size_t>(detail)];
      std::string models = models_text(v, plan);
      ObjectText copies = still_copies_text(parts.space, variant.scene, plan, 0);
      parts.plan = plan;
      for (std::size_t f = 0; f < what_.frames.size(); ++f) {
        bool last = f + 1 == what_.frames.size();
        if (detail > 0 && !last) continue;  // these stand still
        Result<ObjectText> grown = detail == 0 ? fine_text(variant.scene, parts, what_.frames[f])
                                               : coarse_text(variant.scene, parts, heights, detail);
        if (!grown) return grown.errors();
        ObjectText objects = copies;
        if (Errors none = write_shape(v, detail, f, parts, models, objects += *grown); !none.empty())
          return none;
      }
    }
    return {};
  }

  Errors write_shape(std::size_t v, int detail, std::size_t f, const FrameParts& parts,
                     const std::string& models, const ObjectText& text) {
    std::string objects = text.text;
    std::size_t count = text.objects + solids_;
    if (solids_ > 0) objects.insert(0, fmt::format("{}_Solids_{}()\n", what_.name, v));
    bool last = f + 1 == what_.frames.size();
    if (count == 0 && last)
      return {error_at("", "{}frame {}; expected another --frame", kNothingYet, what_.frames[f])};
    if (count == 0) objects = "sphere{0,1e-6 no_image no_shadow no_reflection}\n", count = 1;
    shapes_ += fmt::format("#macro {}_Make_{}_{}_{}()\n", what_.name, v, detail, f);
    shapes_ += fmt::format("{}_Parts_{}()\n", what_.name, v);
    shapes_ += fmt::format("#local Frond_Unit = {};\n", number_text(parts.space.unit)) + models;
    shapes_ += worn_text(variants_[v].scene, parts.first_skin, time_of(f));
    shapes_ += fmt::format("#declare {}_Shapes[{}][{}][{}] = {}{{\n", what_.name, v, detail, f,
                           count > 1 ? "union" : "object");
    // The matrix changes nothing, but has POV-Ray keep a transformation of each shape. Without one `scale -1`
    // in a scene would make radii negative, which are not seen.
    shapes_ += objects + fmt::format("matrix<1,0,0,0,1,0,0,0,1,0,0,0> scale 1/{}}}\n#end\n",
                                     number_text(parts.space.unit));
    return {};
  }

  /// The models of what is sown that a plan shows, each read once, by whichever shape asks first.
  std::string models_text(std::size_t v, const CopyPlan& plan) {
    std::string calls;
    std::set<std::string> names;
    for (std::size_t i = 0; i < plan.files.size(); ++i) {
      const ModelFile& file = plan.files[i];
      const std::vector<Drawn>& drawn = plan.drawn[0][file.copy_set];
      if (std::ranges::find(drawn, file.level, &Drawn::level) == drawn.end() ||
          !names.insert(file.name).second)
        continue;
      std::string first = declared_name(file) + "_0";
      if (models_.insert(file.name).second)
        shapes_ += fmt::format("#macro {}_{}()\n#local Frond_Unit = {};\n{}#end\n", what_.name, first,
                               number_text(kModelUnit), variants_[v].models[i]);
      calls += fmt::format("#ifndef ({}) {}_{}() #end\n", first, what_.name, first);
    }
    return calls;
  }

  /// The text of all that has grown by itself, as in a frame.
  static Result<ObjectText> fine_text(const Scene& scene, const FrameParts& parts, int frame) {
    ObjectText text;
    Result<FrameCount> count = write_frame(scene, parts, "\n{{organisms}}\n", frame,
                                           [&](std::string_view piece) { text.text += piece; });
    if (!count) return count.errors();
    text.objects = count->objects;
    return text;
  }

  /// The text of all that has grown by itself, drawn as models of copies are.
  ObjectText coarse_text(const Scene& scene, const FrameParts& parts, const std::vector<double>& heights,
                         int detail) {
    ObjectText text;
    for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
      const Specimen& b = scene.specimens[i];
      CopySet set;
      set.organism.name = b.name;
      set.appearance.look = b.look;
      ModelFile file;
      file.level = level_at(heights[i], detail - 1);
      file.name = fmt::format("model_{}_{}.inc",
                              made_id(fmt::format("{} {} {}", what_.name, i, scene.film.fps)), file.level);
      Model grown = b.model;
      grown.solids = {};  // these are drawn as they are at any detail
      for (const DrawnBody& body : b.life.develop ? still_bodies(b.model.solids, b.motion.growth)
                                                  : growing_bodies(b.model.solids, b.motion.growth,
                                                                   scene.film.time(what_.frames.back())))
        text += solid_text(parts.space, body, i);
      ModelText model = model_texts({file}, set, grown, {})[0];
      std::string name = declared_name(file);
      text.text += model.title + model.body;
      for (int part : model.parts) {
        // A coral is one part, its skin.
        std::string look = b.look.branches.coral()
                               ? skin_texture(parts.first_skin[i])
                               : fmt::format("{}_{}_Look(<0,1,{}>)", name, part, number_text(b.brightness));
        text += {fmt::format("object{{{}_{} scale {} {}}}\n", name, part,
                             number_text(parts.space.unit / kModelUnit), look),
                 1};
      }
    }
    return text;
  }

  std::string head() const {
    const std::string& name = what_.name;
    std::string text;
    append_comment(text, what_.title.empty() ? name : what_.title);
    text += fmt::format("// Made by Frond from {}.\n//\n", what_.source);
    text += fmt::format("//   #include \"{}\"\n//   object {{ {}(0, 0) translate <4, 0, 0> }}\n//\n",
                        what_.file, name);
    text += fmt::format(
        "// {0}(Seed, Detail)   Seed 0 to {1}: which of the shapes; Detail 0: as in Frond's own pictures,\n"
        "//                       1 and 2: coarser, a mesh a material, for what is far or stands by "
        "hundreds\n",
        name, variants_.size() - 1);
    if (what_.frames.size() > 1)
      text += fmt::format(
          "// {0}_At(Seed, Time)   as it is at that time, seconds from {1} to {2}: in the nearest of {3} "
          "frames,\n"
          "//                       before and after these in the first and the last. More frames a second "
          "are\n"
          "//                       smoother: --set /film/fps=60\n"
          "// {0}_Loop(Seed, Time) the same, beginning anew after the last: for +KC in a film of its "
          "length\n",
          name, number_text(time_of(0)), number_text(time_of(what_.frames.size() - 1)), what_.frames.size());
    text += fmt::format(
        "// {0}_Height, {0}_Low, {0}_High   of the largest, in units of the scene\n//\n"
        "// For a scene in other units declare Frond_Unit: what is scaled to less than a unit high loses "
        "its\n"
        "// shadows, which POV-Ray begins a thousandth of a unit away. To cut it use clipped_by: leaves have "
        "no\n"
        "// inside, of which an intersection warns.\n//\n"
        "// Before the include a scene may declare\n"
        "//   Frond_Unit      units a metre (1)\n"
        "//   Frond_Ambient   light from all around (0.25), for a scene without radiosity\n"
        "//   Frond_Quality   0 to 2, how finely some textures are made (1)\n"
        "// and macros of its own in place of these, with the same arguments:\n",
        name);
    for (const std::string& macro : macros_called(what_.macros, shapes_)) text += "//   " + macro + "\n";
    text += fmt::format(
        "#ifndef ({0}_Included)\n#declare {0}_Included = version;\n#version 3.7;\n"
        "#ifndef (Frond_Unit)    #declare Frond_Unit = 1;       #end\n"
        "#ifndef (Frond_Ambient) #declare Frond_Ambient = 0.25; #end\n"
        "#ifndef (Frond_Quality) #declare Frond_Quality = 1;    #end\n"
        "#declare {0}_Unit = Frond_Unit;\n",
        name);
    return text;
  }

  std::string foot() const {
    const std::string& name = what_.name;
    std::size_t frames = what_.frames.size(), last = frames - 1;
    std::string text = fmt::format("#declare {}_Shapes = array[{}][{}][{}];\n", name, variants_.size(),
                                   kIncludeDetails, frames);
    text += fmt::format("#macro {0}_Make(S, D, F)\n  #switch (S*{1} + D*{2} + F)\n", name,
                        kIncludeDetails * frames, frames);
    for (std::size_t v = 0; v < variants_.size(); ++v)
      for (int d = 0; d < kIncludeDetails; ++d)
        for (std::size_t f = d == 0 ? 0 : last; f < frames; ++f)
          text +=
              fmt::format("    #case ({0}) {1}_Make_{2}_{3}_{4}() #break\n",
                          (v * kIncludeDetails + static_cast<std::size_t>(d)) * frames + f, name, v, d, f);
    text += fmt::format(
        "  #end\n#end\n"
        "#macro {0}_Shape(S, D, F)\n"
        "  #ifndef ({0}_Shapes[S][D][F]) {0}_Make(S, D, F) #end\n"
        "  object {{ {0}_Shapes[S][D][F] scale {0}_Unit }}\n"
        "#end\n"
        "#macro {0}(Seed, Detail)\n"
        "  {0}_Shape(mod(abs(int(Seed)), {1}), max(0, min({2}, int(Detail))), {3})\n"
        "#end\n",
        name, variants_.size(), kIncludeDetails - 1, last);
    if (frames > 1)
      text += fmt::format(
          "#macro {0}_At(Seed, Time)\n"
          "  {0}_Shape(mod(abs(int(Seed)), {1}), 0, max(0, min({2}, int((Time - {3})*{4} + 0.5))))\n"
          "#end\n",
          name, variants_.size(), last, number_text(time_of(0)), number_text(variants_[0].scene.film.fps));
    if (frames > 1)
      text += fmt::format(
          "#macro {0}_Loop(Seed, Time)\n"
          "  #local Frond_Frame = floor((Time - {3})*{4} + 0.5 + 1e-6);\n"
          "  {0}_Shape(mod(abs(int(Seed)), {1}), 0, Frond_Frame - {2}*floor(Frond_Frame/{2}))\n"
          "#end\n",
          name, variants_.size(), frames, number_text(time_of(0)), number_text(variants_[0].scene.film.fps));
    auto corner = [](Vec3 p) {
      std::string at;
      append_point(at, PovSpace{1}, p);
      return at;
    };
    Vec3 low = box_.low, high = box_.high;
    std::swap(low.z, high.z);  // the mirror
    text += fmt::format(
        "#declare {0}_Height = {1}*{0}_Unit;\n#declare {0}_Low = {2}*{0}_Unit;\n"
        "#declare {0}_High = {3}*{0}_Unit;\n#version {0}_Included;\n#end\n",
        name, number_text(high.y), corner(low), corner(high));
    return text;
  }

  double time_of(std::size_t f) const { return variants_[0].scene.film.time(what_.frames[f]); }

  const IncludeText& what_;
  const std::vector<IncludeVariant>& variants_;
  std::string shapes_;
  std::set<std::string> models_;  // files that are written
  std::size_t solids_ = 0;        // objects among the solids of the variant that is written
  Bounds box_;
};

}  // namespace

std::string include_name(std::string_view file) {
  std::string name = "Frond";
  bool begins = true;
  for (char c : file) {
    if (!std::isalnum(static_cast<unsigned char>(c))) {
      begins = true;
      continue;
    }
    if (begins) name += '_';
    name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  for (std::string_view own : {"Frond_Unit", "Frond_Ambient", "Frond_Quality"})
    if (name == own) return name + "_";
  return name;
}

IncludeVariant include_variant(Scene scene) {
  IncludeVariant variant;
  std::erase_if(scene.specimens, [](const Specimen& b) { return b.entry == Traits::kNoEntry; });
  scene.setup.setting = row_of("studio");
  std::set<std::tuple<std::size_t, int, int>> files;
  for (int detail = 0; detail < kIncludeDetails; ++detail) {
    CopyPlan plan;
    plan.drawn.resize(1);
    for (std::size_t s = 0; s < scene.copy_sets.size(); ++s) {
      const CopySet& set = scene.copy_sets[s];
      int level = level_at(tall_of(set), detail);
      std::vector<Drawn>& drawn = plan.drawn[0].emplace_back();
      for (std::uint32_t i = 0; i < set.copies.size(); ++i)
        drawn.push_back({i, ModelFile::kWhole, static_cast<std::int16_t>(level)});
      for (std::uint16_t model : set.copies.model) files.insert({s, static_cast<int>(model), level});
    }
    variant.plans.push_back(std::move(plan));
  }
  for (CopyPlan& plan : variant.plans)
    for (auto [s, model, level] : files)
      plan.files.push_back({s,
                            model,
                            level,
                            ModelFile::kWhole,
                            0,
                            model_file_name(scene.copy_sets[s].organism, model, level),
                            {}});
  variant.scene = std::move(scene);
  return variant;
}

Result<std::string> include_text(const IncludeText& text, const std::vector<IncludeVariant>& variants) {
  return Writer(text, variants).text();
}

}  // namespace frond
