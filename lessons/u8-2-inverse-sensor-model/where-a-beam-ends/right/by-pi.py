# style: pi / 180, without math.radians

end_x = x + reading * math.sin(angle * math.pi / 180)
end_y = y + reading * math.cos(angle * math.pi / 180)
