$VISION
* File: C:\Users\Public\corridor.inpx
* Comment:
* Date: 01/02/2024 12:00:00
* Application: PTV Vissim 2024
*
* Table: Pedestrians In Network
*
* NO: No, Number (Unique pedestrian number)
* SIMSEC: SimSec, Simulation second (Simulation time [s]) [s]
* COORDCENTX: CoordCentX, Coordinate center (x) (X-coordinate of pedestrian’s center)
* COORDCENTY: CoordCentY, Coordinate center (y) (Y-coordinate of pedestrian’s center)
*
* No;SimSec;CoordCentX;CoordCentY
* Number;Simulation second;Coordinate center (x);Coordinate center (y)
*
$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY
1;0.20;0.500;1.250
2;0.20;2.000;1.500
1;0.40;0.750;1.250
