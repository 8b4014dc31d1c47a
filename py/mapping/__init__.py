"""The reference mapper: occupancy grid mapping from poses and readings alone.

May import: the standard library, `bugbot.frames`, `bugbot.errors`. `arrays` alone may import
NumPy and `yaml_text` PyYAML, so that everything else runs where there is none.

    grid.py       the mat as cells in a flat list
    log_odds.py   probabilities, log odds, adding and clamping
    beam.py       the inverse sensor model: what one reading says about which cells
    mapper.py     a grid that takes scans
    frontiers.py  three states, frontier cells, regions, where to go next
    matching.py   which pose makes a scan agree best with the map; following the robot by it
    planning.py   ways for a robot that has a size: where it has room, A*, which region first
    score.py      a map against what really stands on the mat
    arrays.py     the same grid as a NumPy array
    ros_map.py    map files of ROS, with ros_readers.py (the rules of each reader), images.py
                  (image.py, pnm.py, png.py) and map_yaml.py (yaml_text.py)

It marks what learners build and is itself never imported by their programs.
A grid is a flat list, row after row, with row 0 at the bottom of the mat:
index = row * across + column. Lengths in cm, angles in degrees clockwise from up
the mat (`bugbot.frames`).

Where it comes from:
  H. P. Moravec, A. Elfes, "High resolution maps from wide angle sonar", ICRA 1985
  J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems
    Journal 4(1), 1965
  P. E. Hart, N. J. Nilsson, B. Raphael, "A formal basis for the heuristic determination of
    minimum cost paths", IEEE Transactions on Systems Science and Cybernetics 4(2), 1968
  B. Yamauchi, "A frontier-based approach for autonomous exploration", CIRA 1997
  E. Olson, "Real-time correlative scan matching", ICRA 2009
  S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics", MIT Press 2005, chapters 4.2 and 9
"""
