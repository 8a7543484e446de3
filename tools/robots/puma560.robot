# Unimation PUMA 560. Table of K. S. Fu, R. C. Gonzalez and C. S. G. Lee, Robotics: Control, Sensing, Vision, and
# Intelligence (1987), figure 2.11.
robot PUMA 560
angles degrees
lengths mm
rows dh-standard
#         a       alpha  d       theta
revolute  0       -90    0       0      limits -160 160
revolute  431.8   0      149.09  0      limits -225 45
revolute  -20.32  90     0       0      limits -45 225
revolute  0       -90    433.07  0      limits -110 170
revolute  0       90     0       0      limits -100 100
revolute  0       0      56.25   0      limits -266 266
