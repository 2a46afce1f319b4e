angle increment: 45
initial color: 10
color increment: 1
initial line width: 0.6 cylinders
viewpoint: 0,2,10
view reference point: 0,1,0
