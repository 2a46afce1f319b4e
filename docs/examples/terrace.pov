// A palm and a bush on a terrace in a scene of one's own, with radiosity. First, once:
//   frond export presets/garden/palm.json -o palm.inc
//   frond export presets/lsystems/bush-1.25.json --seeds 2 -o bush.inc
// Then: povray +Iterrace.pov +W800 +H500 +A
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

// Terracotta tiles, no two of one colour, in grey joints.
#local Clay = pigment { cells scale 40 color_map { [0 srgb <0.62, 0.38, 0.27>] [1 srgb <0.76, 0.52, 0.38>] } translate -0.01*y }
#local Joint = pigment { srgb <0.46, 0.42, 0.37> }
plane { y, 0
  texture {
    pigment {
      function { select(min(min(mod(x + 40000, 40), 40 - mod(x + 40000, 40)), min(mod(z + 40000, 40), 40 - mod(z + 40000, 40))) - 0.7, 0, 1) }
      pigment_map { [0.5 Joint] [0.5 Clay] }
    }
    normal { granite 0.12 scale 20 }
    finish { ambient 0 diffuse 0.75 specular 0.08 roughness 0.05 }
  }
}

// A limewashed wall: ochre that has run and faded, dark where the rain splashes.
#local Lime = pigment {
  granite turbulence 0.3 color_map { [0.1 srgb <0.84, 0.62, 0.38>] [0.5 srgb <0.90, 0.71, 0.46>] [0.9 srgb <0.95, 0.81, 0.60>] } scale <120, 260, 120>
}
#local Splash = pigment {
  gradient y turbulence 0.04 color_map { [0 srgb <0.45, 0.36, 0.28> transmit 0.35] [0.09 srgb <0.5, 0.4, 0.3> transmit 0.85] [0.22 rgb 1 transmit 1] [1 rgb 1 transmit 1] } scale 420
}
box { <-900, 0, 190>, <900, 330, 220>
  texture { pigment { Lime } normal { granite 0.12 scale 45 } finish { ambient 0 diffuse 0.8 } }
  texture { pigment { Splash } normal { granite 0.12 scale 45 } finish { ambient 0 diffuse 0.8 } }
}
box { <-900, 330, 180>, <900, 342, 225> texture { pigment { srgb <0.72, 0.47, 0.34> } normal { granite 0.2 scale 25 } finish { ambient 0 diffuse 0.75 } } }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.78, 0.87, 0.95>] [0.5 srgb <0.30, 0.53, 0.86>] } } }
light_source { <-6500, 5600, -4200>, rgb <1, 0.91, 0.76>*2.1 area_light x*350, z*350, 5, 5 adaptive 1 orient circular }
camera { location <70, 150, -560> look_at <52, 142, 0> angle 57 right x*image_width/image_height }
