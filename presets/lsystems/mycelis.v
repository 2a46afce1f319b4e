angle increment: 45
initial color: 1
color increment: 1
initial line width: 0.3 cylinders
viewpoint: 0,2,10
view reference point: 0,1,0
surface: l lance_leaf.s 1
surface: y ray.s 1
