// An avenue of aspens in October, in a scene of one's own, without radiosity. First, once:
//   frond export presets/aspen.json --seeds 3 --set /organisms/0/count=1 --set /organisms/0/place/at=[[0,0]] -o aspen.inc
// Then: povray +Iavenue.pov +W800 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Frond_Ambient = 0.15;  // there is no radiosity that would brighten the shade
#include "aspen.inc"

#local Row = 4.3;   // metres from the middle of the way to either row
#local Gap = 6;     // metres from tree to tree
#for (I, 0, 13)
  #for (Side, -1, 1, 2)
    // Three shapes, turned, look like many; what is farther away is drawn more coarsely.
    object {
      Frond_Aspen(I + Side + 1, (I > 1) + (I > 4))
      rotate y*(137*I + 71*Side)
      scale 1 + 0.12*sin(5*I + 2*Side)
      translate <Side*Row, 0, I*Gap>
    }
  #end
#end

// Grass on either side of the way, gold leaves on both, most of them below the trees.
#local Shade = finish { ambient srgb <0.19, 0.23, 0.32> diffuse 0.75 };
#local Grass = pigment { bozo color_map { [0 srgb <0.37, 0.43, 0.15>] [1 srgb <0.25, 0.33, 0.11>] } scale 0.5 }
#local Gravel = pigment { granite color_map { [0.2 srgb <0.64, 0.56, 0.45>] [0.8 srgb <0.48, 0.41, 0.32>] } scale 0.5 }
#local Ragged = pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 0.45 };
#local Noise = function { pigment { Ragged } };
#local Ground = pigment {
  function { select(abs(x) + 0.5*Noise(x, 0, z).red - 2.0, 0, 1) }
  pigment_map { [0.5 Gravel] [0.5 Grass] }
}
#local Leaves = pigment {
  crackle form <1, 0, 0> metric 1
  color_map {
    [0.00 srgb <0.86, 0.60, 0.12>] [0.25 srgb <0.95, 0.74, 0.22>] [0.36 srgb <0.66, 0.42, 0.12>]
    [0.37 srgb <0.5, 0.4, 0.1> transmit 1] [1.00 srgb <0.5, 0.4, 0.1> transmit 1]
  }
  turbulence 0.4 scale 0.12
}
#local None = pigment { rgb 1 transmit 1 }
plane {
  y, 0
  texture { pigment { Ground } normal { granite 0.5 scale 0.25 } finish { Shade } }
  texture {
    pigment {
      function { min(1, max(0, 1.25 - 0.12*abs(abs(x) - 4) - 0.8*Noise(0.3*x, 0, 0.3*z).red)) }
      pigment_map { [0.45 None] [0.55 Leaves] }
    }
    finish { Shade }
  }
}

// A wooded ridge closes the view.
#local Ridge = pigment { bozo turbulence 0.6 color_map { [0.3 srgb <0.34, 0.33, 0.16>] [0.7 srgb <0.52, 0.40, 0.16>] } scale <12, 6, 12> }
#for (I, 0, 4)
  sphere {
    0, 1 scale <260, 26 + 9*mod(3*I, 4), 60> translate <360*(I - 2), 0, 420 + 60*mod(I, 2)>
    texture { pigment { Ridge } normal { bozo 1.5 scale 8 } finish { Shade } }
  }
#end

sky_sphere {
  pigment { gradient y color_map { [0 srgb <0.93, 0.90, 0.84>] [0.18 srgb <0.66, 0.78, 0.91>] [1 srgb <0.22, 0.42, 0.74>] } }
  pigment {
    bozo turbulence 0.7 octaves 6 omega 0.55
    color_map { [0.45 rgb 1 transmit 1] [0.75 srgb <1, 0.98, 0.94> transmit 0.15] }
    scale <0.7, 0.13, 0.7> translate 3*y
  }
}
// The sun stands low to the left before us: leaves glow, shadows lie across the way.
light_source { <-620, 360, 420>, rgb <1, 0.86, 0.62>*3.4 }
fog { fog_type 2 distance 350 fog_offset 0 fog_alt 9 color srgb <0.88, 0.85, 0.78> }
camera { location <0.8, 1.6, -8> look_at <-0.3, 3.6, 20> angle 60 right x*image_width/image_height }
