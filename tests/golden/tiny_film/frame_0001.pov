// Frame 1 of 6. Render with: povray +Lpovinc +RFI +RFframe_0001.rca +W64 +H48 frame_0001.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 0;   // seconds
#declare Frond_Loop = 1;   // seconds, the length of the film
#include "frond_water.inc"
#include "frond_sand.inc"
#include "frond_coral.inc"
#include "frond_food.inc"
Water_Globals(4)
#declare Water_Backdrop = array[6]{<0.003724,0.130153,0.264303,0>,<0.005631,0.205698,0.39375,0.06>,<0.008813,0.321961,0.616305,0.14>,<0.01273,0.465055,0.890218,0.28>,<0.067627,0.693923,1.28261,0.52>,<0.269585,0.96547,1.619567,1>};
Water_Setting(<0,0.6,-2.2>,rgb <0.003724,0.130153,0.264303>,11,<0.35,1,-0.35>,rgb <2.25,2.205,1.98>,1,"frame_0001.caustics")
Water_Particles(<0,0.6,-2.2>,<0,0.3,0>,4)
Water_Surface(<0,0.6,-2.2>,srgb<0.06,0.46,0.62>)
camera{location<0,6,-22> right x*image_width/image_height angle 45 look_at<0,3,0>}
// The skins, old and young.
#declare Skin = array[2];
#declare Skin_Pigment = array[2][2];
#declare Skin_Bleached = array[2];
#declare Skin_Dead = array[2];
Coral_Skin(0,0,srgb<0.85,0.45,0.35>,srgb<0.45,0.14,0.14>,0.018,0.25,0.8,0,1,1,0.88551,0.6) Coral_Starving(0,0,srgb<0.85,0.45,0.35>,srgb<0.45,0.14,0.14>,0.018,0.25,0.8,0,1,1,0.88551,0.6) // staghorn
Coral_Skin(1,0,srgb<0.85,0.45,0.35>,srgb<0.45,0.14,0.14>,0.018,0.25,0.8,0,1,1,1.14027,0.6) Coral_Starving(1,0,srgb<0.85,0.45,0.35>,srgb<0.45,0.14,0.14>,0.018,0.25,0.8,0,1,1,1.14027,0.6) // staghorn

object{
mesh2{
vertex_vectors{7201,<0,-0.2224,0>,<0.0889,-0.2327,-0.0023>,<0.0886,-0.2331,-0.007>,<0.0881,-0.2334,-0.0116>,<0.0874,-0.2... (187158 characters, eb7a9918a1222af8)
normal_vectors{7201,<0.113,0.99,-0.081>,<0.113,0.99,-0.084>,<0.113,0.99,-0.083>,<0.113,0.99,-0.083>,<0.113,0.99,-0.082>,... (137721 characters, 4a443771d6108b24)
face_indices{14280    ,<0,1,2>,<0,2,3>,<0,3,4>,<0,4,5>,<0,5,6>,<0,6,7>,<0,7,8>,<0,8,9>,<0,9,10>,<0,10,11>,<0,11,12>,<0,1... (236010 characters, 2341c9caf787b826)
texture{Sand_Texture()}}
#declare Stone0 = mesh2{
vertex_vectors{2562,<-2.5848,-2.6461,0>,<0,-1.4702,3.7599>,<-3.1937,0,1.9738>,<-2.5432,2.6035,0>,<0,-1.6209,-4.1453>,<3.... (60850 characters, efb6eee4425760cf)
normal_vectors{2562,<-0.279,-0.606,-0.745>,<0.198,-0.968,0.155>,<-0.876,0.45,-0.175>,<0.026,0.822,-0.568>,<0.689,-0.431,... (54302 characters, 69b1208fd4fcf397)
face_indices{5120     ,<0,644,642>,<642,643,162>,<644,164,643>,<642,644,643>,<162,647,645>,<645,646,42>,<647,163,646>,<6... (80438 characters, 5cfdaaac000902ab)
#declare Stone1 = mesh2{
vertex_vectors{2562,<-2.4088,-2.4945,0>,<0,-1.7739,4.4847>,<-4.3038,0,2.6599>,<-2.6084,2.7011,0>,<0,-1.6318,-4.1253>,<4.... (60859 characters, 1e77fde18587cf75)
normal_vectors{2562,<-0.446,-0.825,0.347>,<-0.281,-0.436,0.855>,<-0.86,-0.507,0.054>,<-0.543,0.829,-0.132>,<-0.133,-0.87... (54182 characters, 938e3678f221fae3)
face_indices{5120     ,<0,644,642>,<642,643,162>,<644,164,643>,<642,644,643>,<162,647,645>,<645,646,42>,<647,163,646>,<6... (80438 characters, 5cfdaaac000902ab)
#declare Stone2 = mesh2{
vertex_vectors{2562,<-3.0512,-2.7292,0>,<0,-1.0098,2.9556>,<-4.4494,0,2.7499>,<-3.1612,2.8276,0>,<0,-1.1618,-3.4006>,<3.... (60883 characters, 4fb81fae1591d6fb)
normal_vectors{2562,<-0.308,-0.735,-0.604>,<0.387,-0.424,0.819>,<-0.644,0.426,0.635>,<-0.277,0.96,0.028>,<-0.308,-0.947,... (54245 characters, 6a16ca3a5be84ab0)
face_indices{5120     ,<0,644,642>,<642,643,162>,<644,164,643>,<642,644,643>,<162,647,645>,<645,646,42>,<647,163,646>,<6... (80438 characters, 5cfdaaac000902ab)
#declare Stone3 = mesh2{
vertex_vectors{2562,<-2.7689,-3.3289,0>,<0,-2.0308,4.4224>,<-4.8073,0,2.9711>,<-2.9719,3.5729,0>,<0,-2.0652,-4.4971>,<3.... (60951 characters, 6d2e460723292f15)
normal_vectors{2562,<-0.38,-0.925,-0.001>,<0.423,-0.042,0.905>,<-0.395,-0.546,0.739>,<-0.342,0.864,0.371>,<-0.127,-0.914... (54201 characters, f71e554a63e41519)
face_indices{5120     ,<0,644,642>,<642,643,162>,<644,164,643>,<642,644,643>,<162,647,645>,<645,646,42>,<647,163,646>,<6... (80438 characters, 5cfdaaac000902ab)
#declare Stone4 = mesh2{
vertex_vectors{2562,<-2.5739,-2.5009,0>,<0,-1.4529,3.9146>,<-3.7962,0,2.3462>,<-1.9414,1.8864,0>,<0,-1.9139,-5.1568>,<3.... (60852 characters, e419087c81684da2)
normal_vectors{2562,<-0.708,-0.581,-0.402>,<0.311,0.079,0.947>,<-0.583,-0.786,0.205>,<-0.036,0.992,0.118>,<-0.122,-0.927... (54187 characters, 38719a4cb910b2f4)
face_indices{5120     ,<0,644,642>,<642,643,162>,<644,164,643>,<642,644,643>,<162,647,645>,<645,646,42>,<647,163,646>,<6... (80438 characters, 5cfdaaac000902ab)
object{Stone1 scale<0.06834,0.06307,0.06701>rotate y*-120.232 translate<0.0269,-0.266,7.8948> texture{Rock_Texture(2)}}
object{Stone0 scale<0.02694,0.025,0.02639>rotate y*-152.896 translate<-21.5928,0.136,47.3878> texture{Rock_Texture(1)}}
object{Stone1 scale<0.2,0.20795,0.16803>rotate y*-326.597 translate<4.1363,-0.1722,-0.8038> texture{Rock_Texture(1)}}
object{Stone0 scale<0.2,0.16368,0.19711>rotate y*-193.872 translate<-1.9899,0.1322,3.8778> texture{Rock_Texture(0)}}


object{Food_Swarm() translate<10,6,0>}

