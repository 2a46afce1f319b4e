// Frame 25 of 48. Render with: povray +Lpovinc +RFI +RFlight_c4c2f75cc42bf07e.rca +W64 +H48 frame_0025.pov
#version 3.7;
#declare Frond_Unit = 10;        // POV-Ray units a metre
#declare Frond_Quality = 0;      // 0 draft, 1 good, 2 best
#declare Frond_Time = 1;   // seconds
#declare Frond_Loop = 2;   // seconds, the length of the film
#include "frond_meadow.inc"
#include "frond_forest.inc"
Meadow_Globals()
Forest_Setting(<0,1.7,-14>,<0.22,0.4391,0.7718>,<0.8882,0.9227,0.9063>,<0.649,0.7214,-0.2418>,<4.6915,4.0311,3.0899>,<0.541,0.5264,0.4737>,<1.05,1.0354,1.0109>,6000,0.45,0,-0.18315)
camera{location<0,17,-140> right x*image_width/image_height angle 60 look_at<0,30,100>}
// The skins, old and young.
#declare Skin = array[1];
#declare Skin_Pigment = array[1][2];

#include "part_7f87ad424684eedf.inc"#include "model_4bc5e74552d61afb_1_31.inc"
#include "model_4bc5e74552d61afb_1_45.inc"
#include "model_4bc5e74552d61afb_1_47.inc"
#include "model_4bc5e74552d61afb_1_48.inc"
#include "model_4bc5e74552d61afb_1_65.inc"
#include "model_4bc5e74552d61afb_1_66.inc"
#include "model_4bc5e74552d61afb_1_67.inc"
#include "model_4bc5e74552d61afb_1_70.inc"
#include "model_4bc5e74552d61afb_1_71.inc"
#include "model_4bc5e74552d61afb_1_85.inc"
#include "model_4bc5e74552d61afb_1_86.inc"
#include "model_4bc5e74552d61afb_1_87.inc"
#include "model_4bc5e74552d61afb_2_102.inc"
#include "model_4bc5e74552d61afb_2_103.inc"
#include "model_4bc5e74552d61afb_2_105.inc"
#include "model_4bc5e74552d61afb_2_24.inc"
#include "model_4bc5e74552d61afb_2_27.inc"
#include "model_4bc5e74552d61afb_2_30.inc"
#include "model_4bc5e74552d61afb_2_46.inc"
#include "model_4bc5e74552d61afb_2_47.inc"
#include "model_4bc5e74552d61afb_2_49.inc"
#include "model_4bc5e74552d61afb_2_52.inc"
#include "model_4bc5e74552d61afb_2_65.inc"
#include "model_4bc5e74552d61afb_2_66.inc"
#include "model_4bc5e74552d61afb_2_67.inc"
#include "model_4bc5e74552d61afb_2_68.inc"
#include "model_4bc5e74552d61afb_2_84.inc"
#include "model_4bc5e74552d61afb_2_85.inc"
#include "model_4bc5e74552d61afb_2_87.inc"
#include "model_4bc5e74552d61afb_2_89.inc"
#include "model_4bc5e74552d61afb_2_91.inc"
#include "model_4bc5e74552d61afb_2_92.inc"
#include "model_4bc5e74552d61afb_3_0.inc"
#include "model_4bc5e74552d61afb_3_1.inc"
#include "model_4bc5e74552d61afb_3_10.inc"
#include "model_4bc5e74552d61afb_3_100.inc"
#include "model_4bc5e74552d61afb_3_101.inc"
#include "model_4bc5e74552d61afb_3_102.inc"
#include "model_4bc5e74552d61afb_3_103.inc"
#include "model_4bc5e74552d61afb_3_104.inc"
#include "model_4bc5e74552d61afb_3_105.inc"
#include "model_4bc5e74552d61afb_3_106.inc"
#include "model_4bc5e74552d61afb_3_107.inc"
#include "model_4bc5e74552d61afb_3_108.inc"
#include "model_4bc5e74552d61afb_3_109.inc"
#include "model_4bc5e74552d61afb_3_11.inc"
#include "model_4bc5e74552d61afb_3_110.inc"
#include "model_4bc5e74552d61afb_3_111.inc"
#include "model_4bc5e74552d61afb_3_12.inc"
#include "model_4bc5e74552d61afb_3_13.inc"
#include "model_4bc5e74552d61afb_3_14.inc"
#include "model_4bc5e74552d61afb_3_15.inc"
#include "model_4bc5e74552d61afb_3_16.inc"
#include "model_4bc5e74552d61afb_3_17.inc"
#include "model_4bc5e74552d61afb_3_18.inc"
#include "model_4bc5e74552d61afb_3_19.inc"
#include "model_4bc5e74552d61afb_3_2.inc"
#include "model_4bc5e74552d61afb_3_20.inc"
#include "model_4bc5e74552d61afb_3_21.inc"
#include "model_4bc5e74552d61afb_3_22.inc"
#include "model_4bc5e74552d61afb_3_23.inc"
#include "model_4bc5e74552d61afb_3_24.inc"
#include "model_4bc5e74552d61afb_3_25.inc"
#include "model_4bc5e74552d61afb_3_26.inc"
#include "model_4bc5e74552d61afb_3_27.inc"
#include "model_4bc5e74552d61afb_3_28.inc"
#include "model_4bc5e74552d61afb_3_29.inc"
#include "model_4bc5e74552d61afb_3_3.inc"
#include "model_4bc5e74552d61afb_3_30.inc"
#include "model_4bc5e74552d61afb_3_31.inc"
#include "model_4bc5e74552d61afb_3_32.inc"
#include "model_4bc5e74552d61afb_3_33.inc"
#include "model_4bc5e74552d61afb_3_34.inc"
#include "model_4bc5e74552d61afb_3_35.inc"
#include "model_4bc5e74552d61afb_3_36.inc"
#include "model_4bc5e74552d61afb_3_37.inc"
#include "model_4bc5e74552d61afb_3_38.inc"
#include "model_4bc5e74552d61afb_3_39.inc"
#include "model_4bc5e74552d61afb_3_4.inc"
#include "model_4bc5e74552d61afb_3_40.inc"
#include "model_4bc5e74552d61afb_3_41.inc"
#include "model_4bc5e74552d61afb_3_42.inc"
#include "model_4bc5e74552d61afb_3_43.inc"
#include "model_4bc5e74552d61afb_3_44.inc"
#include "model_4bc5e74552d61afb_3_45.inc"
#include "model_4bc5e74552d61afb_3_46.inc"
#include "model_4bc5e74552d61afb_3_47.inc"
#include "model_4bc5e74552d61afb_3_48.inc"
#include "model_4bc5e74552d61afb_3_49.inc"
#include "model_4bc5e74552d61afb_3_5.inc"
#include "model_4bc5e74552d61afb_3_50.inc"
#include "model_4bc5e74552d61afb_3_51.inc"
#include "model_4bc5e74552d61afb_3_52.inc"
#include "model_4bc5e74552d61afb_3_53.inc"
#include "model_4bc5e74552d61afb_3_54.inc"
#include "model_4bc5e74552d61afb_3_55.inc"
#include "model_4bc5e74552d61afb_3_56.inc"
#include "model_4bc5e74552d61afb_3_57.inc"
#include "model_4bc5e74552d61afb_3_58.inc"
#include "model_4bc5e74552d61afb_3_59.inc"
#include "model_4bc5e74552d61afb_3_6.inc"
#include "model_4bc5e74552d61afb_3_60.inc"
#include "model_4bc5e74552d61afb_3_61.inc"
#include "model_4bc5e74552d61afb_3_62.inc"
#include "model_4bc5e74552d61afb_3_63.inc"
#include "model_4bc5e74552d61afb_3_64.inc"
#include "model_4bc5e74552d61afb_3_65.inc"
#include "model_4bc5e74552d61afb_3_66.inc"
#include "model_4bc5e74552d61afb_3_67.inc"
#include "model_4bc5e74552d61afb_3_68.inc"
#include "model_4bc5e74552d61afb_3_69.inc"
#include "model_4bc5e74552d61afb_3_7.inc"
#include "model_4bc5e74552d61afb_3_70.inc"
#include "model_4bc5e74552d61afb_3_71.inc"
#include "model_4bc5e74552d61afb_3_72.inc"
#include "model_4bc5e74552d61afb_3_73.inc"
#include "model_4bc5e74552d61afb_3_74.inc"
#include "model_4bc5e74552d61afb_3_75.inc"
#include "model_4bc5e74552d61afb_3_76.inc"
#include "model_4bc5e74552d61afb_3_77.inc"
#include "model_4bc5e74552d61afb_3_78.inc"
#include "model_4bc5e74552d61afb_3_79.inc"
#include "model_4bc5e74552d61afb_3_8.inc"
#include "model_4bc5e74552d61afb_3_80.inc"
#include "model_4bc5e74552d61afb_3_81.inc"
#include "model_4bc5e74552d61afb_3_82.inc"
#include "model_4bc5e74552d61afb_3_83.inc"
#include "model_4bc5e74552d61afb_3_84.inc"
#include "model_4bc5e74552d61afb_3_85.inc"
#include "model_4bc5e74552d61afb_3_86.inc"
#include "model_4bc5e74552d61afb_3_87.inc"
#include "model_4bc5e74552d61afb_3_88.inc"
#include "model_4bc5e74552d61afb_3_89.inc"
#include "model_4bc5e74552d61afb_3_9.inc"
#include "model_4bc5e74552d61afb_3_90.inc"
#include "model_4bc5e74552d61afb_3_91.inc"
#include "model_4bc5e74552d61afb_3_92.inc"
#include "model_4bc5e74552d61afb_3_93.inc"
#include "model_4bc5e74552d61afb_3_94.inc"
#include "model_4bc5e74552d61afb_3_95.inc"
#include "model_4bc5e74552d61afb_3_96.inc"
#include "model_4bc5e74552d61afb_3_97.inc"
#include "model_4bc5e74552d61afb_3_98.inc"
#include "model_4bc5e74552d61afb_3_99.inc"
#include "model_4bc5e74552d61afb_4.inc"
#include "model_4bc5e74552d61afb_4_0.inc"
#include "model_4bc5e74552d61afb_4_1.inc"
#include "model_4bc5e74552d61afb_4_10.inc"
#include "model_4bc5e74552d61afb_4_100.inc"
#include "model_4bc5e74552d61afb_4_101.inc"
#include "model_4bc5e74552d61afb_4_102.inc"
#include "model_4bc5e74552d61afb_4_103.inc"
#include "model_4bc5e74552d61afb_4_104.inc"
#include "model_4bc5e74552d61afb_4_105.inc"
#include "model_4bc5e74552d61afb_4_106.inc"
#include "model_4bc5e74552d61afb_4_107.inc"
#include "model_4bc5e74552d61afb_4_108.inc"
#include "model_4bc5e74552d61afb_4_109.inc"
#include "model_4bc5e74552d61afb_4_11.inc"
#include "model_4bc5e74552d61afb_4_110.inc"
#include "model_4bc5e74552d61afb_4_111.inc"
#include "model_4bc5e74552d61afb_4_12.inc"
#include "model_4bc5e74552d61afb_4_13.inc"
#include "model_4bc5e74552d61afb_4_14.inc"
#include "model_4bc5e74552d61afb_4_15.inc"
#include "model_4bc5e74552d61afb_4_16.inc"
#include "model_4bc5e74552d61afb_4_17.inc"
#include "model_4bc5e74552d61afb_4_18.inc"
#include "model_4bc5e74552d61afb_4_19.inc"
#include "model_4bc5e74552d61afb_4_2.inc"
#include "model_4bc5e74552d61afb_4_20.inc"
#include "model_4bc5e74552d61afb_4_21.inc"
#include "model_4bc5e74552d61afb_4_22.inc"
#include "model_4bc5e74552d61afb_4_23.inc"
#include "model_4bc5e74552d61afb_4_24.inc"
#include "model_4bc5e74552d61afb_4_25.inc"
#include "model_4bc5e74552d61afb_4_26.inc"
#include "model_4bc5e74552d61afb_4_27.inc"
#include "model_4bc5e74552d61afb_4_28.inc"
#include "model_4bc5e74552d61afb_4_29.inc"
#include "model_4bc5e74552d61afb_4_3.inc"
#include "model_4bc5e74552d61afb_4_30.inc"
#include "model_4bc5e74552d61afb_4_31.inc"
#include "model_4bc5e74552d61afb_4_32.inc"
#include "model_4bc5e74552d61afb_4_33.inc"
#include "model_4bc5e74552d61afb_4_34.inc"
#include "model_4bc5e74552d61afb_4_35.inc"
#include "model_4bc5e74552d61afb_4_36.inc"
#include "model_4bc5e74552d61afb_4_37.inc"
#include "model_4bc5e74552d61afb_4_38.inc"
#include "model_4bc5e74552d61afb_4_39.inc"
#include "model_4bc5e74552d61afb_4_4.inc"
#include "model_4bc5e74552d61afb_4_40.inc"
#include "model_4bc5e74552d61afb_4_41.inc"
#include "model_4bc5e74552d61afb_4_42.inc"
#include "model_4bc5e74552d61afb_4_43.inc"
#include "model_4bc5e74552d61afb_4_44.inc"
#include "model_4bc5e74552d61afb_4_45.inc"
#include "model_4bc5e74552d61afb_4_46.inc"
#include "model_4bc5e74552d61afb_4_47.inc"
#include "model_4bc5e74552d61afb_4_48.inc"
#include "model_4bc5e74552d61afb_4_49.inc"
#include "model_4bc5e74552d61afb_4_5.inc"
#include "model_4bc5e74552d61afb_4_50.inc"
#include "model_4bc5e74552d61afb_4_51.inc"
#include "model_4bc5e74552d61afb_4_52.inc"
#include "model_4bc5e74552d61afb_4_53.inc"
#include "model_4bc5e74552d61afb_4_54.inc"
#include "model_4bc5e74552d61afb_4_55.inc"
#include "model_4bc5e74552d61afb_4_56.inc"
#include "model_4bc5e74552d61afb_4_57.inc"
#include "model_4bc5e74552d61afb_4_58.inc"
#include "model_4bc5e74552d61afb_4_59.inc"
#include "model_4bc5e74552d61afb_4_6.inc"
#include "model_4bc5e74552d61afb_4_60.inc"
#include "model_4bc5e74552d61afb_4_61.inc"
#include "model_4bc5e74552d61afb_4_62.inc"
#include "model_4bc5e74552d61afb_4_63.inc"
#include "model_4bc5e74552d61afb_4_64.inc"
#include "model_4bc5e74552d61afb_4_65.inc"
#include "model_4bc5e74552d61afb_4_66.inc"
#include "model_4bc5e74552d61afb_4_67.inc"
#include "model_4bc5e74552d61afb_4_68.inc"
#include "model_4bc5e74552d61afb_4_69.inc"
#include "model_4bc5e74552d61afb_4_7.inc"
#include "model_4bc5e74552d61afb_4_70.inc"
#include "model_4bc5e74552d61afb_4_71.inc"
#include "model_4bc5e74552d61afb_4_72.inc"
#include "model_4bc5e74552d61afb_4_73.inc"
#include "model_4bc5e74552d61afb_4_74.inc"
#include "model_4bc5e74552d61afb_4_75.inc"
#include "model_4bc5e74552d61afb_4_76.inc"
#include "model_4bc5e74552d61afb_4_77.inc"
#include "model_4bc5e74552d61afb_4_78.inc"
#include "model_4bc5e74552d61afb_4_79.inc"
#include "model_4bc5e74552d61afb_4_8.inc"
#include "model_4bc5e74552d61afb_4_80.inc"
#include "model_4bc5e74552d61afb_4_81.inc"
#include "model_4bc5e74552d61afb_4_82.inc"
#include "model_4bc5e74552d61afb_4_83.inc"
#include "model_4bc5e74552d61afb_4_84.inc"
#include "model_4bc5e74552d61afb_4_85.inc"
#include "model_4bc5e74552d61afb_4_86.inc"
#include "model_4bc5e74552d61afb_4_87.inc"
#include "model_4bc5e74552d61afb_4_88.inc"
#include "model_4bc5e74552d61afb_4_89.inc"
#include "model_4bc5e74552d61afb_4_9.inc"
#include "model_4bc5e74552d61afb_4_90.inc"
#include "model_4bc5e74552d61afb_4_91.inc"
#include "model_4bc5e74552d61afb_4_92.inc"
#include "model_4bc5e74552d61afb_4_93.inc"
#include "model_4bc5e74552d61afb_4_94.inc"
#include "model_4bc5e74552d61afb_4_95.inc"
#include "model_4bc5e74552d61afb_4_96.inc"
#include "model_4bc5e74552d61afb_4_97.inc"
#include "model_4bc5e74552d61afb_4_98.inc"
#include "model_4bc5e74552d61afb_4_99.inc"
#include "model_db8c11558cbbbd13_1_1.inc"
#include "model_db8c11558cbbbd13_1_17.inc"
#include "model_db8c11558cbbbd13_1_2.inc"
#include "model_db8c11558cbbbd13_1_20.inc"
#include "model_db8c11558cbbbd13_1_21.inc"
#include "model_db8c11558cbbbd13_1_22.inc"
#include "model_db8c11558cbbbd13_1_38.inc"
#include "model_db8c11558cbbbd13_1_43.inc"
#include "model_db8c11558cbbbd13_1_7.inc"
#include "model_db8c11558cbbbd13_1_8.inc"
#include "model_db8c11558cbbbd13_1_82.inc"
#include "model_db8c11558cbbbd13_1_95.inc"
#include "model_db8c11558cbbbd13_2_0.inc"
#include "model_db8c11558cbbbd13_2_19.inc"
#include "model_db8c11558cbbbd13_2_23.inc"
#include "model_db8c11558cbbbd13_2_36.inc"
#include "model_db8c11558cbbbd13_2_42.inc"
#include "model_db8c11558cbbbd13_2_44.inc"
#include "model_db8c11558cbbbd13_2_45.inc"
#include "model_db8c11558cbbbd13_2_58.inc"
#include "model_db8c11558cbbbd13_2_6.inc"
#include "model_db8c11558cbbbd13_2_63.inc"
#include "model_db8c11558cbbbd13_2_65.inc"
#include "model_db8c11558cbbbd13_2_7.inc"
#include "model_db8c11558cbbbd13_2_8.inc"
#include "model_db8c11558cbbbd13_2_83.inc"
#include "model_db8c11558cbbbd13_2_96.inc"
#include "model_db8c11558cbbbd13_2_97.inc"
#include "model_db8c11558cbbbd13_3_0.inc"
#include "model_db8c11558cbbbd13_3_1.inc"
#include "model_db8c11558cbbbd13_3_10.inc"
#include "model_db8c11558cbbbd13_3_100.inc"
#include "model_db8c11558cbbbd13_3_101.inc"
#include "model_db8c11558cbbbd13_3_11.inc"
#include "model_db8c11558cbbbd13_3_12.inc"
#include "model_db8c11558cbbbd13_3_13.inc"
#include "model_db8c11558cbbbd13_3_14.inc"
#include "model_db8c11558cbbbd13_3_15.inc"
#include "model_db8c11558cbbbd13_3_16.inc"
#include "model_db8c11558cbbbd13_3_17.inc"
#include "model_db8c11558cbbbd13_3_18.inc"
#include "model_db8c11558cbbbd13_3_19.inc"
#include "model_db8c11558cbbbd13_3_2.inc"
#include "model_db8c11558cbbbd13_3_20.inc"
#include "model_db8c11558cbbbd13_3_21.inc"
#include "model_db8c11558cbbbd13_3_22.inc"
#include "model_db8c11558cbbbd13_3_23.inc"
#include "model_db8c11558cbbbd13_3_24.inc"
#include "model_db8c11558cbbbd13_3_25.inc"
#include "model_db8c11558cbbbd13_3_26.inc"
#include "model_db8c11558cbbbd13_3_27.inc"
#include "model_db8c11558cbbbd13_3_28.inc"
#include "model_db8c11558cbbbd13_3_29.inc"
#include "model_db8c11558cbbbd13_3_3.inc"
#include "model_db8c11558cbbbd13_3_30.inc"
#include "model_db8c11558cbbbd13_3_31.inc"
#include "model_db8c11558cbbbd13_3_32.inc"
#include "model_db8c11558cbbbd13_3_33.inc"
#include "model_db8c11558cbbbd13_3_34.inc"
#include "model_db8c11558cbbbd13_3_35.inc"
#include "model_db8c11558cbbbd13_3_36.inc"
#include "model_db8c11558cbbbd13_3_37.inc"
#include "model_db8c11558cbbbd13_3_38.inc"
#include "model_db8c11558cbbbd13_3_39.inc"
#include "model_db8c11558cbbbd13_3_4.inc"
#include "model_db8c11558cbbbd13_3_40.inc"
#include "model_db8c11558cbbbd13_3_41.inc"
#include "model_db8c11558cbbbd13_3_42.inc"
#include "model_db8c11558cbbbd13_3_43.inc"
#include "model_db8c11558cbbbd13_3_44.inc"
#include "model_db8c11558cbbbd13_3_45.inc"
#include "model_db8c11558cbbbd13_3_46.inc"
#include "model_db8c11558cbbbd13_3_47.inc"
#include "model_db8c11558cbbbd13_3_48.inc"
#include "model_db8c11558cbbbd13_3_49.inc"
#include "model_db8c11558cbbbd13_3_5.inc"
#include "model_db8c11558cbbbd13_3_50.inc"
#include "model_db8c11558cbbbd13_3_51.inc"
#include "model_db8c11558cbbbd13_3_52.inc"
#include "model_db8c11558cbbbd13_3_53.inc"
#include "model_db8c11558cbbbd13_3_54.inc"
#include "model_db8c11558cbbbd13_3_55.inc"
#include "model_db8c11558cbbbd13_3_56.inc"
#include "model_db8c11558cbbbd13_3_57.inc"
#include "model_db8c11558cbbbd13_3_58.inc"
#include "model_db8c11558cbbbd13_3_59.inc"
#include "model_db8c11558cbbbd13_3_6.inc"
#include "model_db8c11558cbbbd13_3_60.inc"
#include "model_db8c11558cbbbd13_3_61.inc"
#include "model_db8c11558cbbbd13_3_62.inc"
#include "model_db8c11558cbbbd13_3_63.inc"
#include "model_db8c11558cbbbd13_3_64.inc"
#include "model_db8c11558cbbbd13_3_65.inc"
#include "model_db8c11558cbbbd13_3_66.inc"
#include "model_db8c11558cbbbd13_3_67.inc"
#include "model_db8c11558cbbbd13_3_68.inc"
#include "model_db8c11558cbbbd13_3_69.inc"
#include "model_db8c11558cbbbd13_3_7.inc"
#include "model_db8c11558cbbbd13_3_70.inc"
#include "model_db8c11558cbbbd13_3_71.inc"
#include "model_db8c11558cbbbd13_3_72.inc"
#include "model_db8c11558cbbbd13_3_73.inc"
#include "model_db8c11558cbbbd13_3_74.inc"
#include "model_db8c11558cbbbd13_3_75.inc"
#include "model_db8c11558cbbbd13_3_76.inc"
#include "model_db8c11558cbbbd13_3_77.inc"
#include "model_db8c11558cbbbd13_3_78.inc"
#include "model_db8c11558cbbbd13_3_79.inc"
#include "model_db8c11558cbbbd13_3_8.inc"
#include "model_db8c11558cbbbd13_3_80.inc"
#include "model_db8c11558cbbbd13_3_81.inc"
#include "model_db8c11558cbbbd13_3_82.inc"
#include "model_db8c11558cbbbd13_3_83.inc"
#include "model_db8c11558cbbbd13_3_84.inc"
#include "model_db8c11558cbbbd13_3_85.inc"
#include "model_db8c11558cbbbd13_3_86.inc"
#include "model_db8c11558cbbbd13_3_87.inc"
#include "model_db8c11558cbbbd13_3_88.inc"
#include "model_db8c11558cbbbd13_3_89.inc"
#include "model_db8c11558cbbbd13_3_9.inc"
#include "model_db8c11558cbbbd13_3_90.inc"
#include "model_db8c11558cbbbd13_3_91.inc"
#include "model_db8c11558cbbbd13_3_92.inc"
#include "model_db8c11558cbbbd13_3_93.inc"
#include "model_db8c11558cbbbd13_3_94.inc"
#include "model_db8c11558cbbbd13_3_95.inc"
#include "model_db8c11558cbbbd13_3_96.inc"
#include "model_db8c11558cbbbd13_3_97.inc"
#include "model_db8c11558cbbbd13_3_98.inc"
#include "model_db8c11558cbbbd13_3_99.inc"
#include "model_db8c11558cbbbd13_4.inc"
#include "model_db8c11558cbbbd13_4_0.inc"
#include "model_db8c11558cbbbd13_4_1.inc"
#include "model_db8c11558cbbbd13_4_10.inc"
#include "model_db8c11558cbbbd13_4_100.inc"
#include "model_db8c11558cbbbd13_4_101.inc"
#include "model_db8c11558cbbbd13_4_11.inc"
#include "model_db8c11558cbbbd13_4_12.inc"
#include "model_db8c11558cbbbd13_4_13.inc"
#include "model_db8c11558cbbbd13_4_14.inc"
#include "model_db8c11558cbbbd13_4_15.inc"
#include "model_db8c11558cbbbd13_4_16.inc"
#include "model_db8c11558cbbbd13_4_17.inc"
#include "model_db8c11558cbbbd13_4_18.inc"
#include "model_db8c11558cbbbd13_4_19.inc"
#include "model_db8c11558cbbbd13_4_2.inc"
#include "model_db8c11558cbbbd13_4_20.inc"
#include "model_db8c11558cbbbd13_4_21.inc"
#include "model_db8c11558cbbbd13_4_22.inc"
#include "model_db8c11558cbbbd13_4_23.inc"
#include "model_db8c11558cbbbd13_4_24.inc"
#include "model_db8c11558cbbbd13_4_25.inc"
#include "model_db8c11558cbbbd13_4_26.inc"
#include "model_db8c11558cbbbd13_4_27.inc"
#include "model_db8c11558cbbbd13_4_28.inc"
#include "model_db8c11558cbbbd13_4_29.inc"
#include "model_db8c11558cbbbd13_4_3.inc"
#include "model_db8c11558cbbbd13_4_30.inc"
#include "model_db8c11558cbbbd13_4_31.inc"
#include "model_db8c11558cbbbd13_4_32.inc"
#include "model_db8c11558cbbbd13_4_33.inc"
#include "model_db8c11558cbbbd13_4_34.inc"
#include "model_db8c11558cbbbd13_4_35.inc"
#include "model_db8c11558cbbbd13_4_36.inc"
#include "model_db8c11558cbbbd13_4_37.inc"
#include "model_db8c11558cbbbd13_4_38.inc"
#include "model_db8c11558cbbbd13_4_39.inc"
#include "model_db8c11558cbbbd13_4_4.inc"
#include "model_db8c11558cbbbd13_4_40.inc"
#include "model_db8c11558cbbbd13_4_41.inc"
#include "model_db8c11558cbbbd13_4_42.inc"
#include "model_db8c11558cbbbd13_4_43.inc"
#include "model_db8c11558cbbbd13_4_44.inc"
#include "model_db8c11558cbbbd13_4_45.inc"
#include "model_db8c11558cbbbd13_4_46.inc"
#include "model_db8c11558cbbbd13_4_47.inc"
#include "model_db8c11558cbbbd13_4_48.inc"
#include "model_db8c11558cbbbd13_4_49.inc"
#include "model_db8c11558cbbbd13_4_5.inc"
#include "model_db8c11558cbbbd13_4_50.inc"
#include "model_db8c11558cbbbd13_4_51.inc"
#include "model_db8c11558cbbbd13_4_52.inc"
#include "model_db8c11558cbbbd13_4_53.inc"
#include "model_db8c11558cbbbd13_4_54.inc"
#include "model_db8c11558cbbbd13_4_55.inc"
#include "model_db8c11558cbbbd13_4_56.inc"
#include "model_db8c11558cbbbd13_4_57.inc"
#include "model_db8c11558cbbbd13_4_58.inc"
#include "model_db8c11558cbbbd13_4_59.inc"
#include "model_db8c11558cbbbd13_4_6.inc"
#include "model_db8c11558cbbbd13_4_60.inc"
#include "model_db8c11558cbbbd13_4_61.inc"
#include "model_db8c11558cbbbd13_4_62.inc"
#include "model_db8c11558cbbbd13_4_63.inc"
#include "model_db8c11558cbbbd13_4_64.inc"
#include "model_db8c11558cbbbd13_4_65.inc"
#include "model_db8c11558cbbbd13_4_66.inc"
#include "model_db8c11558cbbbd13_4_67.inc"
#include "model_db8c11558cbbbd13_4_68.inc"
#include "model_db8c11558cbbbd13_4_69.inc"
#include "model_db8c11558cbbbd13_4_7.inc"
#include "model_db8c11558cbbbd13_4_70.inc"
#include "model_db8c11558cbbbd13_4_71.inc"
#include "model_db8c11558cbbbd13_4_72.inc"
#include "model_db8c11558cbbbd13_4_73.inc"
#include "model_db8c11558cbbbd13_4_74.inc"
#include "model_db8c11558cbbbd13_4_75.inc"
#include "model_db8c11558cbbbd13_4_76.inc"
#include "model_db8c11558cbbbd13_4_77.inc"
#include "model_db8c11558cbbbd13_4_78.inc"
#include "model_db8c11558cbbbd13_4_79.inc"
#include "model_db8c11558cbbbd13_4_8.inc"
#include "model_db8c11558cbbbd13_4_80.inc"
#include "model_db8c11558cbbbd13_4_81.inc"
#include "model_db8c11558cbbbd13_4_82.inc"
#include "model_db8c11558cbbbd13_4_83.inc"
#include "model_db8c11558cbbbd13_4_84.inc"
#include "model_db8c11558cbbbd13_4_85.inc"
#include "model_db8c11558cbbbd13_4_86.inc"
#include "model_db8c11558cbbbd13_4_87.inc"
#include "model_db8c11558cbbbd13_4_88.inc"
#include "model_db8c11558cbbbd13_4_89.inc"
#include "model_db8c11558cbbbd13_4_9.inc"
#include "model_db8c11558cbbbd13_4_90.inc"
#include "model_db8c11558cbbbd13_4_91.inc"
#include "model_db8c11558cbbbd13_4_92.inc"
#include "model_db8c11558cbbbd13_4_93.inc"
#include "model_db8c11558cbbbd13_4_94.inc"
#include "model_db8c11558cbbbd13_4_95.inc"
#include "model_db8c11558cbbbd13_4_96.inc"
#include "model_db8c11558cbbbd13_4_97.inc"
#include "model_db8c11558cbbbd13_4_98.inc"
#include "model_db8c11558cbbbd13_4_99.inc"
#include "model_4bc5e74552d61afb_3.inc"
#include "model_db8c11558cbbbd13_3.inc"
#declare Tint0 = array[12]{<-3.6667,0.9083,0.8625>,<-0.3333,1.025,0.8875>,<3,0.9417,0.9125>,<-1.6667,1.0583,0.9375>,<1.6667,0.975,0.9625>,<-3,1.0917,0.9875>,<0.3333,1.0083,1.0125>,<3.6667,0.925,1.0375>,<-1,1.0417,1.0625>,<2.3333,0.9583,1.0875>,<-2.3333,1.075,1.1125>,<1,0.9917,1.1375>}
// 
object{
object{Model_db8c11558cbbbd13_1_1_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_1_1_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_1_1_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_1_1_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_1_7_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_7_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_7_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_7_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_8_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_8_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_8_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_8_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_17_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_17_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_17_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_17_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_20_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_20_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_20_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_20_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_21_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_21_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_21_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_21_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_22_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_22_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_22_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_22_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_38_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_38_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_38_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_38_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_43_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_43_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_43_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_1_43_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_82_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_1_82_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_1_82_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_1_82_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_1_95_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_1_95_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_1_95_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_1_95_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_0_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_0_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_0_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_0_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_6_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_6_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_6_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_6_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_7_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_7_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_7_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_7_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_8_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_8_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_8_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_2_8_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_19_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_19_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_19_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_19_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_23_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_23_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_23_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_23_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_23_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_23_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_23_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_23_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_36_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_36_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_42_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_42_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_42_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_42_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_44_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_44_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_44_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_44_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_45_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_45_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_45_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_45_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_58_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_58_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_58_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_58_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_63_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_63_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_63_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_2_63_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_63_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_63_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_63_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_63_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_65_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_65_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_65_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_2_65_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_2_65_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_2_65_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_2_65_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_2_65_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_2_83_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_83_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_83_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_83_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_2_96_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_2_96_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_96_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_2_96_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_2_97_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_2_97_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_3_0 matrix<-0.6624,0.05193,-0.8854,-0.02796,1.10331,0.08563,0.88648,0.07361,-0.6589,174.8071,5.5116,-49.2538>}
object{Model_db8c11558cbbbd13_3_0 matrix<0.21004,-0.09118,-0.9628,-0.02808,0.98425,-0.09934,0.9667,0.0484,0.20631,100.4054,2.0348,9.9886>}
Model_db8c11558cbbbd13_3_0_Look(Tint0[8])}
union{
object{Model_db8c11558cbbbd13_3_1 matrix<-0.6624,0.05193,-0.8854,-0.02796,1.10331,0.08563,0.88648,0.07361,-0.6589,174.8071,5.5116,-49.2538>}
object{Model_db8c11558cbbbd13_3_1 matrix<0.21004,-0.09118,-0.9628,-0.02808,0.98425,-0.09934,0.9667,0.0484,0.20631,100.4054,2.0348,9.9886>}
Model_db8c11558cbbbd13_3_1_Look(Tint0[8])}
object{
object{Model_db8c11558cbbbd13_3_0 matrix<-0.92305,-0.01069,0.69923,-0.03555,1.15713,-0.02924,-0.69841,-0.04477,-0.92265,-62.6483,0.7425,70.8536>}
Model_db8c11558cbbbd13_3_0_Look(Tint0[11])}
object{
object{Model_db8c11558cbbbd13_3_1 matrix<-0.92305,-0.01069,0.69923,-0.03555,1.15713,-0.02924,-0.69841,-0.04477,-0.92265,-62.6483,0.7425,70.8536>}
Model_db8c11558cbbbd13_3_1_Look(Tint0[11])}
object{
object{Model_db8c11558cbbbd13_3_0_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_0_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_1_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_1_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_1_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_1_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_3_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_3_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_3_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_3_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_4_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_4_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_4_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_4_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_4_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_4_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_4_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_4_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_5_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_5_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_5_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_5_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_6_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_6_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_8_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_8_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_9_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_9_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_9_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_9_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_10_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_10_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_10_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_10_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_10_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_10_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_10_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_10_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_11_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_11_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_11_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_11_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_11_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_11_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_11_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_11_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_12_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_12_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_12_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_12_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_12_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_12_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_12_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_12_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_12_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_12_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_12_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_12_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_13_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_13_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_13_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_13_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_13_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_13_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_13_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_13_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_13_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_13_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_13_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_13_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_17_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_17_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_18_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_18_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_18_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_18_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_19_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_19_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_20_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_20_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_20_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_20_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_21_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_21_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_21_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_21_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_22_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_22_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_22_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_22_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_25_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_25_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_25_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_25_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_26_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_26_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_26_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_26_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_26_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_26_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_26_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_3_26_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_27_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_27_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_27_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_27_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_28_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_28_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_28_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_28_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_28_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_28_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_28_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_28_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_29_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_29_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_29_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_29_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_29_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_29_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_29_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_29_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_30_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_30_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_30_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_30_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_30_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_30_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_30_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_30_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_35_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_35_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_36_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_36_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_37_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_37_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_37_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_37_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_38_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_38_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_38_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_38_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_41_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_41_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_41_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_41_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_42_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_42_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_42_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_42_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_43_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_43_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_43_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_43_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_44_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_44_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_45_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_45_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_45_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_3_45_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_3_48_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_48_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_48_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_48_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_49_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_49_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_49_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_49_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_50_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_50_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_50_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_50_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_50_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_50_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_50_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_50_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_51_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_51_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_51_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_51_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_51_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_51_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_51_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_51_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_52_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_52_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_52_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_52_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_52_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_52_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_52_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_52_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_57_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_57_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_57_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_57_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_58_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_58_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_60_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_60_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_61_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_61_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_61_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_61_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_62_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_62_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_62_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_62_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_62_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_62_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_62_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_62_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_63_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_63_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_63_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_63_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_64_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_64_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_64_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_64_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_64_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_64_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_64_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_3_64_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_3_65_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_65_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_65_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_65_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_69_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_69_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_69_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_69_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_70_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_70_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_70_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_70_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_70_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_70_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_70_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_70_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_71_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_71_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_71_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_71_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_71_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_71_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_71_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_71_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_72_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_72_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_72_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_72_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_72_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_72_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_72_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_72_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_72_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_72_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_72_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_72_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_78_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_78_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_79_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_79_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_79_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_79_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_79_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_79_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_79_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_79_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_80_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_80_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_80_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_80_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_80_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_80_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_80_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_80_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_81_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_81_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_81_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_81_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_82_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_82_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_82_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_82_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_83_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_83_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_83_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_83_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_83_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_3_83_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_3_86_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_86_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_86_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_86_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_87_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_87_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_87_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_87_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_88_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_88_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_88_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_88_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_89_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_89_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_89_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_89_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_89_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_89_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_89_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_89_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_90_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_90_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_90_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_90_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_90_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_90_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_90_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_90_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_90_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_90_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_90_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_90_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_91_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_3_91_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_91_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_91_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_91_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_3_91_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_3_91_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_3_91_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_3_95_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_95_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_95_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_95_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_96_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_96_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_96_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_96_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_97_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_97_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_98_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_98_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_98_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_98_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_99_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_99_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_99_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_3_99_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_3_99_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_99_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_99_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_99_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_100_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_100_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_100_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_100_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_3_101_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_3_101_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<-0.27295,-0.02158,-0.88656,-0.03091,0.92728,-0.01305,0.88629,0.02569,-0.27349,-387.4928,4.5502,371.5083>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.22232,0.00091,-0.81291,0.02341,0.84242,-0.00546,0.81258,-0.02403,-0.22225,-165.4905,-1.5095,-91.5703>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.76508,0.01986,0.26095,0.01998,0.80835,-0.00294,-0.26094,0.00367,-0.76533,101.183,5.6828,268.4827>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.91718,0.03084,0.0741,0.02915,0.91996,-0.02209,-0.07478,-0.01966,-0.91743,-105.8985,7.7959,440.985>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[0])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<-0.27295,-0.02158,-0.88656,-0.03091,0.92728,-0.01305,0.88629,0.02569,-0.27349,-387.4928,4.5502,371.5083>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.22232,0.00091,-0.81291,0.02341,0.84242,-0.00546,0.81258,-0.02403,-0.22225,-165.4905,-1.5095,-91.5703>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.76508,0.01986,0.26095,0.01998,0.80835,-0.00294,-0.26094,0.00367,-0.76533,101.183,5.6828,268.4827>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.91718,0.03084,0.0741,0.02915,0.91996,-0.02209,-0.07478,-0.01966,-0.91743,-105.8985,7.7959,440.985>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[0])}
object{
object{Model_db8c11558cbbbd13_4_0 matrix<-0.86804,0.00115,-0.67521,0.00081,1.09973,0.00083,0.67521,0.00016,-0.86804,-357.7997,3.5985,297.6315>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_1 matrix<-0.86804,0.00115,-0.67521,0.00081,1.09973,0.00083,0.67521,0.00016,-0.86804,-357.7997,3.5985,297.6315>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_0 matrix<0.29002,-0.0005,-1.15503,-0.00036,1.19088,-0.0006,1.15503,0.00049,0.29002,-192.2267,-1.5045,-223.6008>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_1 matrix<0.29002,-0.0005,-1.15503,-0.00036,1.19088,-0.0006,1.15503,0.00049,0.29002,-192.2267,-1.5045,-223.6008>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<-1.01449,0.02448,0.37799,0.02415,1.08261,-0.0053,-0.37801,0.00347,-1.01477,387.0177,7.101,-10.192>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.76894,0.02427,-0.83086,0.08279,1.12846,-0.04365,0.82708,-0.09039,-0.76808,-110.3405,4.208,172.7847>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[3])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<-1.01449,0.02448,0.37799,0.02415,1.08261,-0.0053,-0.37801,0.00347,-1.01477,387.0177,7.101,-10.192>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.76894,0.02427,-0.83086,0.08279,1.12846,-0.04365,0.82708,-0.09039,-0.76808,-110.3405,4.208,172.7847>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[3])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<0.3929,-0.06404,-0.93569,-0.04854,1.01173,-0.08962,0.93662,0.07929,0.38787,-19.4539,7.3948,294.5971>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.8253,-0.04268,0.60029,-0.01886,1.02018,0.04661,-0.60151,0.02657,-0.82509,-393.3437,3.5275,207.8139>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[4])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<0.3929,-0.06404,-0.93569,-0.04854,1.01173,-0.08962,0.93662,0.07929,0.38787,-19.4539,7.3948,294.5971>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.8253,-0.04268,0.60029,-0.01886,1.02018,0.04661,-0.60151,0.02657,-0.82509,-393.3437,3.5275,207.8139>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[4])}
object{
object{Model_db8c11558cbbbd13_4_0 matrix<0.85341,0.00844,-0.80103,-0.0059,1.17045,0.00605,0.80105,-0.00037,0.85343,48.3746,5.8116,208.2529>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_1 matrix<0.85341,0.00844,-0.80103,-0.0059,1.17045,0.00605,0.80105,-0.00037,0.85343,48.3746,5.8116,208.2529>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[5])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<0.17448,0.01279,-0.9423,0.07806,0.95483,0.02741,0.93915,-0.08174,0.17278,366.8233,7.5236,168.7232>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.35171,0.06805,1.03134,-0.0317,1.08819,-0.08261,-1.0331,-0.05656,-0.34858,305.1946,7.2912,381.5679>}
object{Model_db8c11558cbbbd13_4_0 matrix<-1.01997,-0.03531,-0.11448,-0.02399,1.02168,-0.10138,0.11738,-0.09802,-1.01553,-289.374,6.1033,327.8157>}
object{Model_db8c11558cbbbd13_4_0 matrix<-1.16473,-0.04237,0.16906,-0.03819,1.17665,0.03173,-0.17005,0.0259,-1.16507,412.5835,6.5377,252.0743>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[6])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<0.17448,0.01279,-0.9423,0.07806,0.95483,0.02741,0.93915,-0.08174,0.17278,366.8233,7.5236,168.7232>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.35171,0.06805,1.03134,-0.0317,1.08819,-0.08261,-1.0331,-0.05656,-0.34858,305.1946,7.2912,381.5679>}
object{Model_db8c11558cbbbd13_4_1 matrix<-1.01997,-0.03531,-0.11448,-0.02399,1.02168,-0.10138,0.11738,-0.09802,-1.01553,-289.374,6.1033,327.8157>}
object{Model_db8c11558cbbbd13_4_1 matrix<-1.16473,-0.04237,0.16906,-0.03819,1.17665,0.03173,-0.17005,0.0259,-1.16507,412.5835,6.5377,252.0743>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[6])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<-0.70788,0.0217,-0.76369,0.01069,1.04129,0.01967,0.76393,0.00553,-0.70794,-146.9599,7.5156,307.3078>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.24428,-0.0467,-1.09706,0.02628,1.12331,-0.05367,1.09774,-0.03728,-0.24284,-185.2672,7.8187,441.3595>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.38998,-0.04502,-0.79643,0.02724,0.88524,-0.06338,0.79724,-0.05227,-0.38742,-191.333,0.339,68.1752>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.9368,0.00329,0.69908,0.00023,1.16888,-0.0058,-0.69909,0.00479,0.93679,-305.5063,0.6087,-6.1152>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<-0.70788,0.0217,-0.76369,0.01069,1.04129,0.01967,0.76393,0.00553,-0.70794,-146.9599,7.5156,307.3078>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.24428,-0.0467,-1.09706,0.02628,1.12331,-0.05367,1.09774,-0.03728,-0.24284,-185.2672,7.8187,441.3595>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.38998,-0.04502,-0.79643,0.02724,0.88524,-0.06338,0.79724,-0.05227,-0.38742,-191.333,0.339,68.1752>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.9368,0.00329,0.69908,0.00023,1.16888,-0.0058,-0.69909,0.00479,0.93679,-305.5063,0.6087,-6.1152>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<0.51886,0.00316,1.05853,-0.02099,1.17866,0.00677,-1.05833,-0.02183,0.51883,241.9097,7.0616,342.6642>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.9904,-0.01224,-0.59709,-0.0093,1.15647,-0.0083,0.59715,-0.0023,-0.99044,167.6797,5.4172,178.2647>}
object{Model_db8c11558cbbbd13_4_0 matrix<1.11977,-0.00582,-0.15572,-0.00241,1.12899,-0.0595,0.15581,0.05926,1.11821,-130.9517,6.6222,237.614>}
object{Model_db8c11558cbbbd13_4_0 matrix<-1.02795,0.08064,-0.35684,0.08708,1.08762,-0.00505,0.35533,-0.03324,-1.0311,109.2193,5.1546,153.1881>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.79489,0.04624,0.76235,-0.03368,1.10137,-0.03169,-0.76301,-0.00044,0.7956,396.5369,6.896,121.1631>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.38281,-0.07936,1.08331,-0.1077,1.14573,0.04588,-1.08086,-0.08606,-0.38825,-46.0178,6.5231,216.3424>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[8])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<0.51886,0.00316,1.05853,-0.02099,1.17866,0.00677,-1.05833,-0.02183,0.51883,241.9097,7.0616,342.6642>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.9904,-0.01224,-0.59709,-0.0093,1.15647,-0.0083,0.59715,-0.0023,-0.99044,167.6797,5.4172,178.2647>}
object{Model_db8c11558cbbbd13_4_1 matrix<1.11977,-0.00582,-0.15572,-0.00241,1.12899,-0.0595,0.15581,0.05926,1.11821,-130.9517,6.6222,237.614>}
object{Model_db8c11558cbbbd13_4_1 matrix<-1.02795,0.08064,-0.35684,0.08708,1.08762,-0.00505,0.35533,-0.03324,-1.0311,109.2193,5.1546,153.1881>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.79489,0.04624,0.76235,-0.03368,1.10137,-0.03169,-0.76301,-0.00044,0.7956,396.5369,6.896,121.1631>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.38281,-0.07936,1.08331,-0.1077,1.14573,0.04588,-1.08086,-0.08606,-0.38825,-46.0178,6.5231,216.3424>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[8])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<0.81167,-0.02522,-0.19802,0.02614,0.83544,0.00074,0.1979,-0.00691,0.81206,225.3799,6.243,122.1352>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.97359,0.03479,-0.38104,-0.02575,1.04534,0.02964,0.38176,-0.01821,0.97376,219.9804,7.1876,-115.4316>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.77863,-0.04284,-0.26525,0.0464,0.82237,0.00338,0.26465,-0.01814,0.7798,-158.1861,2.67,156.8184>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[9])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<0.81167,-0.02522,-0.19802,0.02614,0.83544,0.00074,0.1979,-0.00691,0.81206,225.3799,6.243,122.1352>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.97359,0.03479,-0.38104,-0.02575,1.04534,0.02964,0.38176,-0.01821,0.97376,219.9804,7.1876,-115.4316>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.77863,-0.04284,-0.26525,0.0464,0.82237,0.00338,0.26465,-0.01814,0.7798,-158.1861,2.67,156.8184>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[9])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<1.1724,-0.04747,0.04583,0.04636,1.17299,0.02893,-0.04695,-0.02707,1.17301,165.5606,4.4464,81.1117>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.03851,-0.00324,0.99059,0.01393,0.99124,0.0027,-0.9905,0.01382,0.03856,-264.4612,1.573,156.0587>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.21246,0.00053,-0.78291,-0.07929,0.80707,-0.02097,0.77889,0.08201,0.21143,-18.1882,7.7986,389.4832>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[10])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<1.1724,-0.04747,0.04583,0.04636,1.17299,0.02893,-0.04695,-0.02707,1.17301,165.5606,4.4464,81.1117>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.03851,-0.00324,0.99059,0.01393,0.99124,0.0027,-0.9905,0.01382,0.03856,-264.4612,1.573,156.0587>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.21246,0.00053,-0.78291,-0.07929,0.80707,-0.02097,0.77889,0.08201,0.21143,-18.1882,7.7986,389.4832>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[10])}
union{
object{Model_db8c11558cbbbd13_4_0 matrix<-0.87656,-0.03243,-0.79539,-0.0364,1.18349,-0.00813,0.79522,0.01843,-0.87712,316.4736,7.5723,110.0634>}
object{Model_db8c11558cbbbd13_4_0 matrix<-0.93347,-0.01911,0.34668,-0.01858,0.99577,0.00486,-0.34671,-0.00192,-0.93365,-35.35,3.0978,118.1888>}
object{Model_db8c11558cbbbd13_4_0 matrix<0.07239,-0.03757,-0.81106,0.03884,0.8135,-0.03421,0.811,-0.03561,0.07404,251.3233,6.8383,-7.3022>}
Model_db8c11558cbbbd13_4_0_Look(Tint0[11])}
union{
object{Model_db8c11558cbbbd13_4_1 matrix<-0.87656,-0.03243,-0.79539,-0.0364,1.18349,-0.00813,0.79522,0.01843,-0.87712,316.4736,7.5723,110.0634>}
object{Model_db8c11558cbbbd13_4_1 matrix<-0.93347,-0.01911,0.34668,-0.01858,0.99577,0.00486,-0.34671,-0.00192,-0.93365,-35.35,3.0978,118.1888>}
object{Model_db8c11558cbbbd13_4_1 matrix<0.07239,-0.03757,-0.81106,0.03884,0.8135,-0.03421,0.811,-0.03561,0.07404,251.3233,6.8383,-7.3022>}
Model_db8c11558cbbbd13_4_1_Look(Tint0[11])}
object{
object{Model_db8c11558cbbbd13_4_0_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_0_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_0_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_0_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_0_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_0_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_0_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_0_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_1_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_1_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_1_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_1_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_1_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_1_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_1_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_1_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_3_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_3_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_3_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_3_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_3_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_3_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_3_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_3_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_4_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_4_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_4_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_4_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_4_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_4_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_4_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_4_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_4_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_4_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_4_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_4_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_4_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_4_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_4_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_4_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_5_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_5_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_5_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_5_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_5_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_5_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_5_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_5_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_6_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_6_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_6_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_6_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_6_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_6_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_6_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_6_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_7_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_7_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_7_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_7_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_7_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_7_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_7_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_7_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_8_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_8_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_8_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_8_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_8_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_8_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_9_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_9_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_9_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_9_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_9_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_9_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_9_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_9_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_10_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_10_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_10_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_10_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_10_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_10_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_10_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_10_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_11_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_11_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_11_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_11_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_11_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_11_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_11_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_11_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_11_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_11_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_11_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_11_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_11_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_11_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_11_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_11_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_12_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_12_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_12_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_12_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_12_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_12_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_13_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_13_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_13_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_13_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_13_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_13_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_14_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_14_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_14_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_14_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_14_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_14_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_14_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_14_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_14_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_14_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_15_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_15_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_15_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_15_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_15_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_15_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_15_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_15_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_15_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_15_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_16_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_16_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_16_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_16_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_16_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_16_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_16_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_16_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_16_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_16_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_17_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_17_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_17_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_17_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_17_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_17_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_17_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_17_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_18_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_18_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_18_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_18_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_18_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_18_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_18_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_18_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_19_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_19_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_19_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_19_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_19_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_19_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_19_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_19_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_20_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_20_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_20_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_20_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_20_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_20_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_20_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_20_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_21_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_21_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_21_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_21_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_21_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_21_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_22_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_22_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_22_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_22_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_22_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_22_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_23_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_23_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_23_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_23_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_23_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_23_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_23_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_24_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_24_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_24_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_24_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_24_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_24_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_24_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_24_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_24_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_24_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_25_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_25_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_25_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_25_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_25_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_25_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_25_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_25_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_25_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_26_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_26_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_26_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_26_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_26_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_26_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_26_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_26_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_27_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_27_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_27_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_27_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_27_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_27_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_27_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_27_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_27_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_27_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_27_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_27_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_27_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_27_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_27_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_27_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_27_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_27_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_28_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_28_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_28_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_28_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_28_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_28_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_28_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_29_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_29_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_29_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_29_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_29_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_29_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_29_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_30_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_30_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_30_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_30_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_30_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_30_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_30_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_30_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_30_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_30_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_30_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_30_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_30_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_30_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_31_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_31_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_31_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_31_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_31_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_31_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_31_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_31_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_31_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_31_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_32_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_32_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_32_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_32_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_32_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_32_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_32_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_32_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_32_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_32_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_33_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_33_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_33_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_33_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_33_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_33_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_33_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_33_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_33_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_33_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_34_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_34_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_34_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_34_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_34_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_34_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_34_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_34_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_34_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_34_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_35_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_35_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_35_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_35_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_35_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_35_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_35_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_35_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_36_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_36_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_36_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_36_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_36_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_36_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_36_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_36_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_38_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_38_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_38_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_38_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_38_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_38_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_38_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_38_0_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_39_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_39_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_39_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_39_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_39_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_39_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_39_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_39_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_39_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_39_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_41_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_41_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_41_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_41_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_41_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_41_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_41_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_41_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_41_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_41_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_41_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_41_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_41_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_41_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_41_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_41_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_41_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_41_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_42_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_42_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_42_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_42_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_42_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_42_0_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_42_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_42_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_42_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_42_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_42_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_42_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_42_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_42_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_42_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_42_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_43_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_43_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_43_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_43_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_43_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_43_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_43_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_44_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_44_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_44_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_44_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_44_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_44_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_44_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_45_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_45_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_45_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_45_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_45_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_46_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_46_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_46_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_46_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_46_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_46_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_46_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_46_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_46_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_46_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_47_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_47_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_47_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_47_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_47_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_47_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_47_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_47_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_47_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_47_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_48_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_48_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_48_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_48_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_48_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_48_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_48_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_48_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_48_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_49_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_49_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_49_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_49_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_49_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_49_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_49_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_49_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_49_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_49_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_49_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_49_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_49_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_49_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_49_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_49_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_49_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_49_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_50_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_50_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_50_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_50_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_50_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_50_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_50_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_50_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_50_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_50_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_50_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_50_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_50_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_50_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_51_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_51_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_51_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_51_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_51_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_51_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_51_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_51_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_51_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_51_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_51_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_51_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_51_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_51_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_52_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_52_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_52_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_52_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_52_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_52_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_52_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_52_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_52_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_52_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_52_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_52_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_52_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_52_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_53_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_53_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_53_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_53_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_53_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_53_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_53_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_53_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_53_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_53_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_54_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_54_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_54_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_54_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_54_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_54_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_54_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_54_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_54_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_54_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_55_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_55_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_55_0_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_55_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_55_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_55_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_55_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_55_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_55_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_55_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_55_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_55_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_55_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_55_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_55_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_55_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_55_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_55_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_55_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_55_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_56_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_56_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_56_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_56_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_56_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_56_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_56_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_56_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_56_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_56_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_57_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_57_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_57_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_57_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_57_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_57_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_57_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_57_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_59_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_59_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_59_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_59_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_59_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_59_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_59_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_59_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_59_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_59_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_60_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_60_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_60_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_60_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_60_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_60_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_60_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_60_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_60_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_61_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_61_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_61_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_61_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_61_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_61_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_61_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_61_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_61_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_62_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_62_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_62_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_62_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_62_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_62_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_62_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_62_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_63_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_63_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_63_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_63_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_63_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_63_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_64_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_64_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_64_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_64_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_65_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_65_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_65_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_65_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_66_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_66_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_66_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_66_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_66_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_66_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_66_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_66_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_66_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_66_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_67_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_67_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_67_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_67_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_67_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_67_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_67_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_67_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_67_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_67_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_68_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_68_0 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_68_0_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_68_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_68_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_68_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_68_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_68_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_68_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_68_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_68_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_68_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_68_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_68_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_68_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_68_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_68_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_68_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_68_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_68_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_69_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_69_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_69_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_69_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_69_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_69_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_69_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_69_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_69_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_70_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_70_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_70_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_70_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_70_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_70_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_70_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_71_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_71_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_71_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_71_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_71_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_71_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_71_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_72_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_72_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_72_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_72_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_72_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_72_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_73_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_73_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_73_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_73_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_73_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_73_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_73_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_73_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_73_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_73_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_74_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_74_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_74_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_74_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_74_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_74_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_74_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_74_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_74_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_74_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_75_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_75_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_75_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_75_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_75_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_75_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_75_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_75_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_75_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_75_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_76_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_76_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_76_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_76_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_76_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_76_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_76_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_76_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_76_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_76_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_77_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_77_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_77_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_77_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_77_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_77_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_77_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_77_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_77_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_77_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_78_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_78_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_78_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_78_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_78_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_78_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_78_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_78_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_78_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_79_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_79_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_79_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_79_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_79_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_79_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_79_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_79_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_80_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_80_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_80_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_80_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_80_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_80_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_80_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_80_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_81_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_81_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_81_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_81_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_81_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_81_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_81_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_81_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_82_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_82_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_82_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_82_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_82_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_82_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_83_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_83_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_83_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_83_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_85_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_85_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_85_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_85_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_85_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_85_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_85_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_85_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_85_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_85_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_86_0 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_86_0_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_86_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_86_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_86_0 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_86_0 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_86_0_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_86_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_86_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_86_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_86_0 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_86_0_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_86_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_86_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_86_0 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_86_0_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_86_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_86_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_87_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_87_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_87_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_87_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_87_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_87_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_87_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_87_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_87_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_88_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_88_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_88_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_88_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_88_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_88_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_88_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_88_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_88_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_89_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_89_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_89_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_89_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_89_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_89_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_89_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_89_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_90_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_90_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_90_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_90_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_90_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_90_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_91_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_91_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_91_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_91_1_Look(Tint0[2])}
union{
object{Model_db8c11558cbbbd13_4_92_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_92_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_92_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_92_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_92_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_92_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_92_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_92_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_92_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_92_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_93_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_93_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_93_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_93_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_93_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_93_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_93_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_93_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_93_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_93_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_94_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_94_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_94_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_94_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_94_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_94_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_94_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_94_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_94_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_94_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_95_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_95_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_95_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_95_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_95_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_95_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_95_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_95_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_96_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_96_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_96_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_96_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_96_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_96_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_96_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_96_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_97_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_97_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_97_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_97_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_97_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_97_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_97_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_97_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_98_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_98_1_Look(Tint0[1])}
union{
object{Model_db8c11558cbbbd13_4_98_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
object{Model_db8c11558cbbbd13_4_98_1 matrix<-0.97234,0.04468,0.20822,0.02833,0.99173,-0.08051,-0.21107,-0.07272,-0.97003,63.9094,0.8315,-166.7682>}
Model_db8c11558cbbbd13_4_98_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_98_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_98_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_98_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_98_1_Look(Tint0[7])}
object{
object{Model_db8c11558cbbbd13_4_99_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
Model_db8c11558cbbbd13_4_99_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_99_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_99_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_99_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_99_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_99_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_99_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_100_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_100_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_100_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_100_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_100_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_100_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_100_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_100_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_100_1_Look(Tint0[7])}
union{
object{Model_db8c11558cbbbd13_4_101_1 matrix<-0.67542,-0.00527,0.52649,-0.03156,0.85521,-0.03193,-0.52557,-0.04459,-0.67468,-32.1908,-1.4872,-128.4882>}
object{Model_db8c11558cbbbd13_4_101_1 matrix<0.03025,-0.00695,1.18269,-0.06019,1.18153,0.00848,-1.18118,-0.06039,0.02986,63.9064,0.3554,-259.9944>}
Model_db8c11558cbbbd13_4_101_1_Look(Tint0[1])}
object{
object{Model_db8c11558cbbbd13_4_101_1 matrix<0.84422,-0.03646,0.0566,0.0374,0.84597,-0.01287,-0.05598,0.01532,0.8449,84.9119,1.7361,-97.9511>}
Model_db8c11558cbbbd13_4_101_1_Look(Tint0[2])}
object{
object{Model_db8c11558cbbbd13_4_101_1 matrix<0.86645,0.01648,-0.16162,-0.02556,0.87991,-0.04733,0.16044,0.05121,0.86532,28.016,0.3419,-0.7693>}
Model_db8c11558cbbbd13_4_101_1_Look(Tint0[5])}
object{
object{Model_db8c11558cbbbd13_4_101_1 matrix<-0.8903,0.00002,-0.74933,0.00001,1.16367,0.00002,0.74933,0.00002,-0.8903,134.3704,4.0991,-205.5412>}
Model_db8c11558cbbbd13_4_101_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_31_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_1_31_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_1_31_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_1_31_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_1_45_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_45_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_45_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_45_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_47_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_47_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_47_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_47_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_48_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_48_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_48_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_48_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_65_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_1_65_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_1_65_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_1_65_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_1_66_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_66_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_66_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_66_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_66_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_1_66_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_1_66_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_1_66_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_1_67_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_67_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_67_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_67_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_70_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_1_70_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_70_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_1_70_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_71_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_1_71_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_71_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_1_71_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_85_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_85_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_85_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_85_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_86_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_1_86_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_1_86_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_1_86_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_1_86_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_86_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_86_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_1_86_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_1_87_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_1_87_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_1_87_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_1_87_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_24_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_24_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_27_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_27_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_27_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_27_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_30_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_2_30_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_2_46_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_46_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_46_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_46_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_47_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_47_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_49_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_49_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_49_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_49_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_52_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_2_52_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_2_52_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_2_52_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_2_52_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_2_52_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_52_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_2_52_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_65_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_65_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_65_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_65_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_66_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_66_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_67_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_67_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_67_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_67_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_67_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_67_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_67_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_67_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_68_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_68_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_68_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_68_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_68_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_68_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_68_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_68_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_84_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_84_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_84_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_84_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_84_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_84_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_84_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_84_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_85_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_85_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_85_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_85_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_85_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_85_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_85_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_2_85_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_2_87_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_87_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_87_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_87_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_89_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_2_89_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_2_89_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_2_89_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_2_91_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_91_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_91_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_91_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_92_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_92_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_92_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_92_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_102_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_102_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_102_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_102_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_103_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_103_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_103_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_2_103_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_2_103_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_103_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_103_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_2_103_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_2_105_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_2_105_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_0 matrix<0.60452,-0.00898,0.70948,-0.04525,0.92968,0.05032,-0.70809,-0.06708,0.60249,44.9496,-0.6153,-334.3588>}
Model_4bc5e74552d61afb_3_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_1 matrix<0.60452,-0.00898,0.70948,-0.04525,0.92968,0.05032,-0.70809,-0.06708,0.60249,44.9496,-0.6153,-334.3588>}
Model_4bc5e74552d61afb_3_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_0 matrix<0.36308,0.01204,0.79874,0.06309,0.8742,-0.04186,-0.79634,0.07475,0.36086,118.6916,3.181,65.1631>}
Model_4bc5e74552d61afb_3_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_1 matrix<0.36308,0.01204,0.79874,0.06309,0.8742,-0.04186,-0.79634,0.07475,0.36086,118.6916,3.181,65.1631>}
Model_4bc5e74552d61afb_3_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_0 matrix<0.35143,0.04515,0.95855,0.00663,1.02067,-0.0505,-0.95959,0.02358,0.3507,-142.4905,-1.8716,-220.4034>}
Model_4bc5e74552d61afb_3_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_1 matrix<0.35143,0.04515,0.95855,0.00663,1.02067,-0.0505,-0.95959,0.02358,0.3507,-142.4905,-1.8716,-220.4034>}
Model_4bc5e74552d61afb_3_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_4_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_4_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_8_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_8_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_10_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_10_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_11_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_11_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_11_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_11_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_12_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_12_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_12_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_12_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_12_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_12_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_12_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_12_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_13_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_13_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_17_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_17_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_17_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_17_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_19_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_19_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_19_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_19_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_20_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_20_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_20_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_20_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_25_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_25_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_25_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_25_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_25_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_25_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_26_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_26_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_26_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_26_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_26_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_26_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_27_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_27_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_27_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_27_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_27_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_27_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_27_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_27_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_28_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_28_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_28_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_28_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_28_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_28_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_28_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_28_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_28_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_28_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_28_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_28_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_29_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_29_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_29_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_29_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_31_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_31_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_33_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_33_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_33_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_33_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_33_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_33_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_33_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_33_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_34_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_34_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_34_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_34_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_34_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_34_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_34_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_34_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_34_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_34_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_34_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_34_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_35_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_35_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_35_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_35_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_36_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_36_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_36_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_36_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_37_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_37_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_37_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_37_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_38_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_38_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_38_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_38_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_44_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_44_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_44_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_44_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_45_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_45_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_45_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_45_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_45_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_45_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_45_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_45_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_46_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_46_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_46_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_46_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_47_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_47_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_48_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_48_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_48_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_48_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_48_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_48_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_48_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_48_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_49_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_49_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_49_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_49_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_49_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_49_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_49_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_49_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_50_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_50_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_50_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_50_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_50_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_50_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_51_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_51_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_51_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_51_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_51_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_51_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_52_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_52_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_53_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_53_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_53_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_53_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_53_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_53_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_53_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_53_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_53_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_53_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_53_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_53_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_54_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_54_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_54_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_54_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_54_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_54_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_54_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_54_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_54_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_54_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_54_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_54_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_55_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_55_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_55_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_55_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_55_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_55_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_55_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_55_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_55_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_55_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_55_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_55_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_56_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_56_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_56_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_56_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_56_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_56_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_56_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_56_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_57_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_57_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_57_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_57_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_57_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_57_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_57_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_57_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_58_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_58_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_58_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_58_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_59_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_59_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_59_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_59_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_59_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_59_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_59_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_59_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_59_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_59_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_59_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_59_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_61_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_61_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_61_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_61_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_65_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_65_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_68_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_68_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_68_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_68_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_68_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_68_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_68_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_68_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_69_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_69_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_69_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_69_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_70_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_70_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_70_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_70_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_71_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_3_71_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_3_72_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_72_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_72_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_72_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_72_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_72_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_72_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_72_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_72_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_72_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_72_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_72_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_73_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_73_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_73_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_73_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_73_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_73_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_73_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_73_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_73_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_73_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_73_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_73_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_74_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_74_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_74_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_74_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_74_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_74_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_74_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_74_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_74_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_74_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_74_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_74_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_75_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_75_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_75_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_75_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_75_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_75_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_75_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_75_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_75_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_75_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_75_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_75_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_76_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_76_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_76_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_76_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_76_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_76_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_76_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_76_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_77_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_77_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_77_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_77_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_77_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_77_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_77_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_77_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_78_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_78_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_78_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_78_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_78_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_78_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_78_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_78_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_79_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_79_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_80_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_80_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_80_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_80_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_84_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_84_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_84_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_84_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_86_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_86_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_86_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_86_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_87_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_87_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_87_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_87_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_88_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_88_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_88_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_88_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_89_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_89_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_90_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_90_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_90_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_90_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_90_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_90_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_90_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_90_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_90_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_90_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_90_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_90_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_91_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_91_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_91_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_91_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_91_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_91_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_91_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_91_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_92_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_92_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_92_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_92_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_92_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_92_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_92_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_92_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_93_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_93_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_93_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_93_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_93_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_93_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_93_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_93_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_93_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_93_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_93_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_93_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_93_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_93_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_93_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_93_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_94_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_94_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_94_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_94_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_95_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_95_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_95_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_95_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_95_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_95_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_95_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_95_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_96_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_96_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_96_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_3_96_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_97_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_97_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_98_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_98_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_101_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_101_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_101_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_101_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_102_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_102_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_102_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_102_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_103_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_103_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_103_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_103_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_104_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_104_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_104_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_104_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_104_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_104_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_104_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_3_104_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_3_105_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_105_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_106_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_106_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_107_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_107_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_107_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_107_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_107_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_107_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_107_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_107_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_107_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_107_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_107_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_107_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_108_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_108_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_108_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_108_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_108_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_108_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_108_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_108_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_108_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_108_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_108_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_108_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_3_109_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_109_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_109_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_109_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_111_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_3_111_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_3_111_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_3_111_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_3_111_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_3_111_1_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<-0.30949,0.00977,-0.74297,-0.01762,0.80452,0.01792,0.74283,0.02315,-0.30913,341.3495,7.5583,214.7262>}
object{Model_4bc5e74552d61afb_4_0 matrix<1.11211,0.04593,0.42666,-0.08179,1.18614,0.0855,-0.42126,-0.10904,1.10977,-86.1343,7.3484,266.0505>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[0])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<-0.30949,0.00977,-0.74297,-0.01762,0.80452,0.01792,0.74283,0.02315,-0.30913,341.3495,7.5583,214.7262>}
object{Model_4bc5e74552d61afb_4_1 matrix<1.11211,0.04593,0.42666,-0.08179,1.18614,0.0855,-0.42126,-0.10904,1.10977,-86.1343,7.3484,266.0505>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[0])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.96349,-0.01422,-0.38947,0.04243,1.03628,0.06713,0.38741,-0.07813,0.96125,-168.8631,7.7524,367.2396>}
object{Model_4bc5e74552d61afb_4_0 matrix<1.12217,0.04245,0.28693,-0.06753,1.1533,0.09351,-0.28208,-0.10725,1.11908,438.7053,7.5689,43.6501>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.25451,0.01077,-1.04786,0.06162,1.0763,0.02603,1.0461,-0.06602,0.25341,324.2107,7.2636,351.8686>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.51563,0.02948,0.94114,0.10721,1.06787,0.02529,-0.93548,0.10614,-0.51585,-82.8536,2.3873,118.5312>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[1])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.96349,-0.01422,-0.38947,0.04243,1.03628,0.06713,0.38741,-0.07813,0.96125,-168.8631,7.7524,367.2396>}
object{Model_4bc5e74552d61afb_4_1 matrix<1.12217,0.04245,0.28693,-0.06753,1.1533,0.09351,-0.28208,-0.10725,1.11908,438.7053,7.5689,43.6501>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.25451,0.01077,-1.04786,0.06162,1.0763,0.02603,1.0461,-0.06602,0.25341,324.2107,7.2636,351.8686>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.51563,0.02948,0.94114,0.10721,1.06787,0.02529,-0.93548,0.10614,-0.51585,-82.8536,2.3873,118.5312>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[1])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<-0.23053,0.02652,-0.8842,0.07608,0.91094,0.00749,0.88132,-0.0717,-0.23193,16.1129,6.3327,198.6143>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.45082,-0.00015,1.01329,0.03288,1.10847,-0.01447,-1.01276,0.03593,0.45059,242.5292,7.4689,-174.9131>}
object{Model_4bc5e74552d61afb_4_0 matrix<1.01202,-0.0572,-0.61696,0.05154,1.18524,-0.02534,0.61746,-0.00518,1.01332,441.1077,6.8702,150.0789>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.34035,0.01878,-1.13412,-0.01226,1.18407,0.01593,1.13421,0.00716,0.3405,258.623,7.1272,152.2312>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[2])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<-0.23053,0.02652,-0.8842,0.07608,0.91094,0.00749,0.88132,-0.0717,-0.23193,16.1129,6.3327,198.6143>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.45082,-0.00015,1.01329,0.03288,1.10847,-0.01447,-1.01276,0.03593,0.45059,242.5292,7.4689,-174.9131>}
object{Model_4bc5e74552d61afb_4_1 matrix<1.01202,-0.0572,-0.61696,0.05154,1.18524,-0.02534,0.61746,-0.00518,1.01332,441.1077,6.8702,150.0789>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.34035,0.01878,-1.13412,-0.01226,1.18407,0.01593,1.13421,0.00716,0.3405,258.623,7.1272,152.2312>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_0 matrix<-0.99399,-0.02255,-0.19414,-0.02416,1.01271,0.00607,0.19395,0.01059,-0.99423,238.1495,7.1194,-41.9927>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[4])}
object{
object{Model_4bc5e74552d61afb_4_1 matrix<-0.99399,-0.02255,-0.19414,-0.02416,1.01271,0.00607,0.19395,0.01059,-0.99423,238.1495,7.1194,-41.9927>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[4])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.98101,-0.02723,0.63468,0.02659,1.1684,0.00904,-0.63471,0.00685,0.98135,423.6512,5.013,444.4692>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.61977,0.02225,-0.64773,0.00635,0.89639,0.02472,0.64808,0.0125,-0.61968,183.257,5.3052,121.6181>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.09124,0.03463,-1.00501,0.04085,1.00818,0.03845,1.00478,-0.04413,0.08969,-292.3639,7.1766,423.1149>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.90862,-0.01527,0.09946,0.0242,0.91023,-0.08127,-0.09767,0.08341,0.90511,-403.1214,3.7753,327.6146>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.20091,-0.00559,0.96203,0.02191,0.98251,0.01028,-0.9618,0.02354,-0.20073,63.6354,7.5692,334.8279>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.98101,-0.02723,0.63468,0.02659,1.1684,0.00904,-0.63471,0.00685,0.98135,423.6512,5.013,444.4692>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.61977,0.02225,-0.64773,0.00635,0.89639,0.02472,0.64808,0.0125,-0.61968,183.257,5.3052,121.6181>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.09124,0.03463,-1.00501,0.04085,1.00818,0.03845,1.00478,-0.04413,0.08969,-292.3639,7.1766,423.1149>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.90862,-0.01527,0.09946,0.0242,0.91023,-0.08127,-0.09767,0.08341,0.90511,-403.1214,3.7753,327.6146>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.20091,-0.00559,0.96203,0.02191,0.98251,0.01028,-0.9618,0.02354,-0.20073,63.6354,7.5692,334.8279>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_0 matrix<0.64698,-0.01672,-1.0057,0.0188,1.19578,-0.00779,1.00567,-0.01159,0.64715,147.8373,3.961,-280.685>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[6])}
object{
object{Model_4bc5e74552d61afb_4_1 matrix<0.64698,-0.01672,-1.0057,0.0188,1.19578,-0.00779,1.00567,-0.01159,0.64715,147.8373,3.961,-280.685>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[6])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.66127,0.05207,-0.67532,-0.05369,0.94486,0.02029,0.67519,0.02413,0.66301,371.2524,7.3423,80.9766>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.46241,0.0098,0.74472,0.02778,0.8762,0.00572,-0.74427,0.02662,-0.46248,106.6129,5.2565,189.6057>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.82867,-0.03822,-0.32691,-0.02274,0.89014,-0.04642,0.32835,-0.03481,-0.82825,-215.2928,0.697,98.0712>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.66127,0.05207,-0.67532,-0.05369,0.94486,0.02029,0.67519,0.02413,0.66301,371.2524,7.3423,80.9766>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.46241,0.0098,0.74472,0.02778,0.8762,0.00572,-0.74427,0.02662,-0.46248,106.6129,5.2565,189.6057>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.82867,-0.03822,-0.32691,-0.02274,0.89014,-0.04642,0.32835,-0.03481,-0.82825,-215.2928,0.697,98.0712>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.50157,0.05574,-0.75637,-0.03644,0.90754,0.04271,0.75755,0.00675,0.50285,-241.9241,-0.1154,23.3488>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.11625,-0.00698,-0.89713,0.01199,0.90454,-0.0086,0.89708,-0.01299,-0.11614,-146.4253,4.7382,199.796>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[8])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.50157,0.05574,-0.75637,-0.03644,0.90754,0.04271,0.75755,0.00675,0.50285,-241.9241,-0.1154,23.3488>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.11625,-0.00698,-0.89713,0.01199,0.90454,-0.0086,0.89708,-0.01299,-0.11614,-146.4253,4.7382,199.796>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[8])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.23818,-0.01357,-0.92149,0.00178,0.95177,-0.01355,0.92159,0.00167,0.23818,-64.4333,7.3923,430.8007>}
object{Model_4bc5e74552d61afb_4_0 matrix<-1.17394,-0.05589,-0.20894,-0.0705,1.18906,0.07804,0.20447,0.08909,-1.17268,252.9278,7.4021,279.8717>}
object{Model_4bc5e74552d61afb_4_0 matrix<-1.08096,0.09273,-0.26945,0.10078,1.11313,-0.02125,0.26655,-0.04484,-1.08472,-126.7738,7.7519,415.801>}
object{Model_4bc5e74552d61afb_4_0 matrix<0.76184,0.03149,0.8616,-0.01527,1.15008,-0.02853,-0.86204,0.00746,0.76195,-319.1388,1.62,101.9212>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[9])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.23818,-0.01357,-0.92149,0.00178,0.95177,-0.01355,0.92159,0.00167,0.23818,-64.4333,7.3923,430.8007>}
object{Model_4bc5e74552d61afb_4_1 matrix<-1.17394,-0.05589,-0.20894,-0.0705,1.18906,0.07804,0.20447,0.08909,-1.17268,252.9278,7.4021,279.8717>}
object{Model_4bc5e74552d61afb_4_1 matrix<-1.08096,0.09273,-0.26945,0.10078,1.11313,-0.02125,0.26655,-0.04484,-1.08472,-126.7738,7.7519,415.801>}
object{Model_4bc5e74552d61afb_4_1 matrix<0.76184,0.03149,0.8616,-0.01527,1.15008,-0.02853,-0.86204,0.00746,0.76195,-319.1388,1.62,101.9212>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[9])}
union{
object{Model_4bc5e74552d61afb_4_0 matrix<0.68659,0.00214,-0.86677,0.00433,1.10573,0.00616,0.86677,-0.00722,0.68656,185.8959,6.5471,-208.6902>}
object{Model_4bc5e74552d61afb_4_0 matrix<-0.03239,0.03884,-0.92704,-0.05966,0.9256,0.04087,0.92594,0.061,-0.02979,-228.7872,6.8325,299.7089>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[10])}
union{
object{Model_4bc5e74552d61afb_4_1 matrix<0.68659,0.00214,-0.86677,0.00433,1.10573,0.00616,0.86677,-0.00722,0.68656,185.8959,6.5471,-208.6902>}
object{Model_4bc5e74552d61afb_4_1 matrix<-0.03239,0.03884,-0.92704,-0.05966,0.9256,0.04087,0.92594,0.061,-0.02979,-228.7872,6.8325,299.7089>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_0 matrix<0.80285,0.01177,0.5281,0.03266,0.95785,-0.071,-0.52722,0.07725,0.79979,-203.4543,2.0203,158.5165>}
Model_4bc5e74552d61afb_4_0_Look(Tint0[11])}
object{
object{Model_4bc5e74552d61afb_4_1 matrix<0.80285,0.01177,0.5281,0.03266,0.95785,-0.071,-0.52722,0.07725,0.79979,-203.4543,2.0203,158.5165>}
Model_4bc5e74552d61afb_4_1_Look(Tint0[11])}
object{
object{Model_4bc5e74552d61afb_4_1_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_1_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_1_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_1_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_1_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_1_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_1_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_1_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_1_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_1_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_1_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_2_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_2_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_2_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_2_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_2_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_2_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_2_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_2_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_2_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_2_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_2_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_3_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_3_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_3_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_3_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_3_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_3_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_3_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_3_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_3_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_3_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_3_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_4_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_4_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_4_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_4_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_4_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_4_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_4_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_4_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_4_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_5_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_5_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_5_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_5_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_5_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_5_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_5_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_5_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_5_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_5_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_5_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_6_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_6_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_6_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_6_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_6_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_6_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_6_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_6_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_6_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_6_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_6_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_6_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_6_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_6_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_6_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_6_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_6_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_6_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_6_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_6_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_6_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_6_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_7_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_7_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_7_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_7_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_7_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_7_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_7_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_7_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_7_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_7_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_7_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_8_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_8_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_8_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_8_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_8_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_8_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_8_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_8_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_8_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_10_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_10_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_10_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_10_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_10_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_10_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_10_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_10_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_10_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_10_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_11_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_11_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_11_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_11_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_11_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_11_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_11_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_11_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_11_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_11_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_11_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_11_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_11_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_11_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_11_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_11_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_11_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_11_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_11_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_11_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_12_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_12_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_12_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_12_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_12_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_12_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_12_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_12_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_15_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_15_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_15_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_15_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_15_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_15_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_15_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_15_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_15_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_15_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_15_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_16_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_16_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_16_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_16_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_16_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_16_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_16_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_16_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_16_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_16_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_16_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_17_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_17_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_17_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_17_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_17_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_17_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_17_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_17_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_17_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_17_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_18_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_18_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_18_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_18_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_18_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_18_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_18_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_18_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_18_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_18_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_18_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_19_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_19_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_19_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_19_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_19_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_19_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_19_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_19_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_19_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_20_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_20_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_20_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_20_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_20_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_20_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_20_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_20_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_20_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_21_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_21_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_21_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_21_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_21_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_21_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_21_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_21_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_21_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_21_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_21_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_22_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_22_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_22_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_22_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_22_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_22_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_22_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_22_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_22_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_22_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_22_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_23_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_23_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_23_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_23_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_23_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_23_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_23_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_23_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_23_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_23_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_23_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_24_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_24_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_24_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_24_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_24_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_24_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_25_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_25_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_25_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_25_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_25_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_25_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_26_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_26_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_26_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_26_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_26_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_26_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_27_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_27_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_27_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_27_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_27_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_27_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_28_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_28_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_28_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_28_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_28_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_28_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_28_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_28_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_28_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_28_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_28_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_28_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_29_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_29_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_29_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_29_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_29_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_29_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_29_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_29_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_32_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_32_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_32_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_32_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_32_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_32_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_32_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_32_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_32_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_32_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_32_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_33_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_33_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_33_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_33_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_33_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_33_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_33_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_33_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_33_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_33_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_33_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_33_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_33_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_33_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_33_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_33_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_34_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_34_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_34_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_34_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_34_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_34_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_35_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_35_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_35_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_35_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_35_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_35_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_35_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_35_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_35_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_35_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_36_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_36_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_36_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_36_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_36_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_36_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_36_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_36_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_36_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_36_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_36_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_36_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_36_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_36_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_36_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_36_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_36_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_36_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_37_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_37_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_37_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_37_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_37_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_37_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_37_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_37_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_37_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_38_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_38_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_38_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_38_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_38_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_38_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_38_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_38_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_39_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_39_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_39_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_39_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_39_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_39_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_39_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_39_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_39_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_39_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_39_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_39_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_39_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_39_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_39_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_39_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_39_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_39_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_39_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_39_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_39_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_39_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_40_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_40_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_40_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_40_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_40_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_40_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_40_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_40_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_40_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_40_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_40_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_41_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_41_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_41_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_41_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_41_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_41_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_41_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_41_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_41_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_41_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_41_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_42_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_42_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_42_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_42_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_42_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_42_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_42_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_42_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_42_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_42_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_42_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_43_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_43_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_43_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_43_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_43_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_43_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_43_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_43_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_43_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_43_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_43_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_43_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_43_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_43_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_43_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_43_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_43_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_43_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_43_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_43_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_43_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_43_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_44_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_44_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_44_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_44_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_44_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_44_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_44_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_44_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_45_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_45_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_45_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_45_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_45_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_45_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_46_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_46_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_46_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_46_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_46_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_46_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_48_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_48_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_48_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_48_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_48_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_48_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_48_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_48_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_48_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_48_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_48_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_48_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_49_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_49_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_49_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_49_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_49_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_49_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_49_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_49_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_49_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_49_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_49_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_49_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_50_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_50_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_50_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_50_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_50_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_50_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_52_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_52_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_52_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_52_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_52_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_52_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_53_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_53_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_53_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_53_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_53_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_53_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_54_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_54_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_54_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_54_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_54_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_54_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_55_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_55_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_55_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_55_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_55_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_55_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_55_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_55_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_55_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_55_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_55_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_55_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_56_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_56_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_56_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_56_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_56_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_56_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_56_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_56_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_56_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_56_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_56_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_56_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_56_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_56_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_56_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_56_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_57_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_57_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_57_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_57_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_57_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_57_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_57_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_57_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_57_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_57_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_57_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_57_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_57_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_57_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_57_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_57_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_58_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_58_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_58_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_58_1_Look(Tint0[2])}
union{
object{Model_4bc5e74552d61afb_4_58_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_58_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_58_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_58_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_58_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_59_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_59_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_59_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_59_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_59_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_59_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_60_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_60_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_60_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_60_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_60_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_60_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_60_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_60_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_60_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_60_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_60_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_61_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_61_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_61_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_61_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_61_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_61_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_61_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_61_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_61_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_61_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_62_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_62_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_62_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_62_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_62_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_62_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_62_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_62_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_62_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_62_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_62_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_62_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_62_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_62_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_62_0_Look(Tint0[7])}
union{
object{Model_4bc5e74552d61afb_4_62_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_62_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_62_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_62_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_62_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_62_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_62_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_63_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_63_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_63_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_63_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_63_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_63_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_63_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_63_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_63_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_63_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_63_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_64_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_64_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_64_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_64_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_64_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_64_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_64_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_64_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_64_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_64_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_64_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_65_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_65_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_65_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_65_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_65_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_65_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_66_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_66_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_66_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_66_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_66_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_66_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_67_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_67_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_67_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_67_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_67_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_67_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_67_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_67_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_67_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_67_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_67_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_67_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_68_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_68_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_68_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_68_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_69_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_69_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_69_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_69_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_69_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_69_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_69_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_69_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_70_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_70_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_70_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_70_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_70_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_70_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_72_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_72_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_72_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_72_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_72_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_72_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_73_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_73_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_73_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_73_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_73_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_73_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_73_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_73_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_73_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_73_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_73_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_73_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_74_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_74_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_74_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_74_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_74_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_74_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_74_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_74_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_74_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_74_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_74_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_74_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_75_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_75_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_75_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_75_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_75_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_75_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_75_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_75_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_75_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_75_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_75_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_75_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_76_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_76_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_76_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_76_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_76_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_76_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_76_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_76_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_76_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_76_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_76_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_76_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_76_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_76_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_76_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_76_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_77_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_77_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_77_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_77_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_77_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_77_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_77_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_77_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_77_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_77_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_77_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_77_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_77_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_77_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_77_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_77_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_78_0 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_78_0_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_78_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_78_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_78_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_78_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_78_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_78_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_78_0 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_78_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_78_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_78_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_78_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_78_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_78_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_78_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_79_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_79_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_79_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_79_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_79_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_79_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_79_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_79_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_79_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_79_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_80_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_80_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_80_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_80_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_80_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_80_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_80_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_80_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_80_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_80_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_81_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_81_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_81_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_81_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_81_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_81_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_81_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_81_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_81_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_81_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_81_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_82_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_82_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_82_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_82_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_82_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_82_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_82_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_82_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_82_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_82_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_82_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_83_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_83_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_83_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_83_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_83_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_83_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_83_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_83_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_83_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_83_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_83_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_84_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_84_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_84_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_84_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_84_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_84_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_85_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_85_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_85_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_85_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_85_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_85_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_86_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_86_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_86_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_86_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_87_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_87_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_87_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_87_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_88_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_88_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_88_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_88_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_88_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_88_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_88_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_88_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_89_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_89_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_89_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_89_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_89_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_89_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_89_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_89_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_90_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_90_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_90_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_90_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_90_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_90_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_91_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_91_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_91_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_91_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_91_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_91_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_91_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_91_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_91_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_91_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_91_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_91_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_92_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_92_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_92_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_92_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_92_0 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_92_0_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_92_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_92_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_92_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_92_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_92_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_92_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_93_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_93_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_93_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_93_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_94_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_94_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_94_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_94_1_Look(Tint0[2])}
union{
object{Model_4bc5e74552d61afb_4_94_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_94_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_94_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_94_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_94_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_95_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_95_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_95_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_95_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_95_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_95_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_95_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_95_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_96_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_96_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_96_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_96_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_96_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_96_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_96_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_96_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_97_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_97_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_97_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_97_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_97_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_97_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_97_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_97_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_97_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_97_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_98_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_98_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_98_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_98_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_98_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_98_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_98_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_98_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_98_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_98_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_99_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_99_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_99_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_99_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_99_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_99_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_99_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_99_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_99_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_99_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_99_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_100_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_100_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_100_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_100_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_100_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_100_1_Look(Tint0[5])}
union{
object{Model_4bc5e74552d61afb_4_100_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_100_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_100_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_100_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_100_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_101_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_101_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_101_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_101_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_101_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_101_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_101_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_101_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_102_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_102_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_102_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_102_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_102_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_102_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_103_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_103_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_103_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_103_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_104_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_104_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_104_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_104_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_105_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_105_1_Look(Tint0[2])}
union{
object{Model_4bc5e74552d61afb_4_105_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_105_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_105_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_105_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_105_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_106_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_106_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_106_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_106_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_106_1 matrix<0.54743,-0.02185,-0.74649,0.02334,0.92561,-0.00997,0.74644,-0.01292,0.54778,-2.059,-0.0934,7.8056>}
Model_4bc5e74552d61afb_4_106_1_Look(Tint0[5])}
object{
object{Model_4bc5e74552d61afb_4_106_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_106_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_106_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_106_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_107_0 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_107_0_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_107_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_107_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_107_0 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_107_0_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_107_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_107_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_107_0 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_107_0_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_107_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_107_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_108_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_108_1_Look(Tint0[2])}
object{
object{Model_4bc5e74552d61afb_4_108_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
Model_4bc5e74552d61afb_4_108_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_108_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_108_1_Look(Tint0[10])}
object{
object{Model_4bc5e74552d61afb_4_109_1 matrix<0.78889,0.01946,-0.85312,0.01683,1.16124,0.04205,0.85317,-0.0409,0.78801,-70.0496,-1.7022,-98.3373>}
Model_4bc5e74552d61afb_4_109_1_Look(Tint0[1])}
object{
object{Model_4bc5e74552d61afb_4_109_1 matrix<0.84627,-0.04041,-0.59396,0.00712,1.03293,-0.06012,0.59529,0.04508,0.8451,92.7252,2.0151,-50.4411>}
Model_4bc5e74552d61afb_4_109_1_Look(Tint0[2])}
union{
object{Model_4bc5e74552d61afb_4_109_1 matrix<-0.54016,0.0388,-0.77948,0.05064,0.94771,0.01209,0.7788,-0.03471,-0.54141,95.1022,2.1158,-168.9269>}
object{Model_4bc5e74552d61afb_4_109_1 matrix<0.17894,-0.06205,0.80229,0.00862,0.82199,0.06165,-0.80464,-0.005,0.17907,24.6077,-0.3133,-163.2091>}
Model_4bc5e74552d61afb_4_109_1_Look(Tint0[7])}
object{
object{Model_4bc5e74552d61afb_4_109_1 matrix<-1.1288,0.0938,-0.07555,0.09465,1.13121,-0.00977,0.07448,-0.01602,-1.13265,28.2823,-0.0494,-36.6623>}
Model_4bc5e74552d61afb_4_109_1_Look(Tint0[10])}



