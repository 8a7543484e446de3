# A SCARA of the AdeptOne's proportions: links of 425 and 375 mm, 877 mm to the arm's plane and 200 mm from there to
# the tool, as published for it. The spindle travels downwards; joint ranges are those of a usual machine of this kind.
robot SCARA
angles degrees
lengths mm
rows screws
#          axis     point
revolute   0 0 1    0 0 877      limits -150 150
revolute   0 0 1    425 0 877    limits -140 140
prismatic  0 0 -1                limits 0 195
revolute   0 0 -1   800 0 877    limits -270 270
home  1 0 0 800   0 -1 0 0   0 0 -1 677
