# Universal Robots UR5e. Dimensions and joint ranges as the maker publishes them: "Parameters for calculations of
# kinematics and dynamics" (support article 45257) and the technical details of the UR5e (+-360 degrees in every joint).
robot UR5e
angles degrees
lengths m
rows dh-standard
#         a       alpha  d       theta
revolute  0       90     0.1625  0      limits -360 360
revolute  -0.425  0      0       0      limits -360 360
revolute  -0.3922 0      0       0      limits -360 360
revolute  0       90     0.1333  0      limits -360 360
revolute  0       -90    0.0997  0      limits -360 360
revolute  0       0      0.0996  0      limits -360 360
