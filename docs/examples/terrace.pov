// A palm and a bush on a terrace in a scene of one's own, with radiosity. First, once:
//   frond export presets/garden/palm.json -o palm.inc
//   frond export presets/lsystems/bush-1.25.json --seeds 2 -o bush.inc
// Then: povray +Iterrace.pov +W640 +H400 +A
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity {
    pretrace_start 0.08 pretrace_end 0.02
    count 50 nearest_count 5 error_bound 1 low_error_factor 0.6 minimum_reuse 0.015
    recursion_limit 1 gray_threshold 0 brightness 1
  }
}

// This scene is built in centimetres.
#declare Frond_Unit = 100;
#include "palm.inc"
#include "bush.inc"

object { Frond_Palm(0, 0) rotate y*120 scale 0.4 translate <-90, 42, 40> }
object { Frond_Bush(0, 0) scale 0.6 translate <95, 42, 10> }
object { Frond_Bush(1, 0) scale 0.5 translate <215, 42, 60> }

#macro Pot(At, Wide)
  difference {
    cone { 0, 0.7*Wide, y*44, Wide }
    cylinder { y*40, y*45, 0.88*Wide }
    translate At
    texture { pigment { srgb <0.72, 0.42, 0.27> } normal { granite 0.1 scale 40 } finish { ambient 0 diffuse 0.75 } }
  }
  cylinder { y*38, y*41, 0.88*Wide translate At texture { pigment { srgb <0.22, 0.16, 0.11> } normal { granite 0.6 scale 5 } } }
#end
Pot(<-90, 0, 40>, 34)
Pot(<95, 0, 10>, 34)
Pot(<215, 0, 60>, 30)

plane { y, 0
  pigment { brick srgb <0.70, 0.66, 0.58>, srgb <0.80, 0.75, 0.66> brick_size <60, 60, 60> mortar 1.2 }
  normal { granite 0.08 scale 20 }
  finish { ambient 0 diffuse 0.75 }
}
box { <-900, 0, 190>, <900, 330, 220> texture { pigment { srgb <0.93, 0.88, 0.79> } normal { granite 0.1 scale 60 } finish { ambient 0 diffuse 0.8 } } }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.80, 0.87, 0.93>] [0.5 srgb <0.40, 0.60, 0.88>] } } }
light_source { <-6000, 7000, -6000>, rgb <1, 0.95, 0.86>*2 area_light x*400, z*400, 5, 5 adaptive 1 orient circular }
camera { location <60, 150, -520> look_at <62, 122, 0> angle 58 right x*image_width/image_height }
