// An avenue of aspens in a scene of one's own, without radiosity. First, once:
//   frond export presets/aspen.json --seeds 3 --set /organisms/0/count=1 --set /organisms/0/place/at=[[0,0]] -o aspen.inc
// Then: povray +Iavenue.pov +W640 +H360 +A
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Frond_Ambient = 0.14;  // there is no radiosity that would brighten the shade
#include "aspen.inc"

#local Row = 4.5;   // metres from the middle of the way to either row
#local Gap = 6;     // metres from tree to tree
#for (I, 0, 9)
  #for (Side, -1, 1, 2)
    // Three shapes, turned, look like many; what is farther away is drawn more coarsely.
    object {
      Frond_Aspen(I + Side + 1, (I > 1) + (I > 4))
      rotate y*(137*I + 71*Side)
      translate <Side*Row, 0, I*Gap>
    }
  #end
#end

plane { y, 0
  texture { pigment { bozo color_map { [0 srgb <0.36, 0.42, 0.16>] [1 srgb <0.28, 0.37, 0.13>] } scale 0.7 } normal { granite 0.3 scale 0.4 } finish { ambient srgb <0.20, 0.24, 0.34> diffuse 0.7 } }
}
box { <-1.9, 0, -50>, <1.9, 0.02, 400>
  texture { pigment { granite color_map { [0 srgb <0.70, 0.64, 0.54>] [1 srgb <0.58, 0.52, 0.42>] } scale 0.6 } normal { granite 0.2 scale 0.2 } finish { ambient srgb <0.20, 0.24, 0.34> diffuse 0.7 } }
}
sky_sphere { pigment { gradient y color_map { [0 srgb <0.80, 0.86, 0.93>] [0.25 srgb <0.46, 0.65, 0.91>] [1 srgb <0.20, 0.40, 0.76>] } } }
light_source { <-700, 480, -260>, rgb <1, 0.90, 0.72>*2.2 }
fog { fog_type 2 distance 400 fog_offset 0 fog_alt 4 color srgb <0.80, 0.86, 0.93> }
camera { location <0.9, 1.7, -9> look_at <-0.3, 4.1, 20> angle 62 right x*image_width/image_height }
