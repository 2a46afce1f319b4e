// Frame {{frame}} of {{frames}}. Render with: povray +Lpovinc {{light}}+W{{width}} +H{{height}} {{file}}{{tone}}
#version 3.7;
#declare Frond_Unit = {{unit}};        // POV-Ray units a metre
#declare Frond_Quality = {{quality}};      // 0 draft, 1 good, 2 best
#declare Frond_Time = {{time}};   // seconds
#declare Frond_Loop = {{loop}};   // seconds, the length of the film
{{includes}}
{{setting}}
{{camera}}
// The skins, old and young.
{{materials}}
{{ground}}
{{organisms}}
{{food}}
