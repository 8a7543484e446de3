# Franka Emika Panda, seven joints. Dimensions in Craig's convention and joint ranges as the maker publishes them, in
# "Robot and interface specifications" of the Franka Control Interface; the tool is the flange.
robot Panda
angles radians
lengths m
rows dh-modified
#         a        alpha                d      theta
revolute  0        0                    0.333  0      limits -2.8973 2.8973
revolute  0        -1.5707963267948966  0      0      limits -1.7628 1.7628
revolute  0        1.5707963267948966   0.316  0      limits -2.8973 2.8973
revolute  0.0825   1.5707963267948966   0      0      limits -3.0718 -0.0698
revolute  -0.0825  -1.5707963267948966  0.384  0      limits -2.8973 2.8973
revolute  0        1.5707963267948966   0      0      limits -0.0175 3.7525
revolute  0.088    1.5707963267948966   0      0      limits -2.8973 2.8973
tool 0 0 0.107
