#include <frond/frond.h>

#include <iostream>

// Grows an oak of a given age, says what stands there and writes it as glTF: grow_oak YEARS FILE.glb
int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "grow_oak YEARS FILE.glb\n", 2;
  try {
    frond::api::Preset preset = frond::api::Preset::read("oak");
    preset.set("/organisms/0/years", argv[1]);
    frond::api::Scene scene = frond::api::grow(preset);
    for (const auto& organism : scene.organisms())
      std::cout << organism.name << ": " << organism.nodes << " nodes\n";
    scene.export_to(argv[2], {.detail = 5000, .texture = 0});
  } catch (const frond::api::Failure& failure) {
    std::cerr << failure.what() << '\n';
    return failure.of_input() ? 2 : 1;
  }
}
