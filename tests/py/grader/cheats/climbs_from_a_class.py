# task: map
# tries: every class there is, from the mother of all
# told: while it is marked a program can't use .__subclasses__
for each in object.__subclasses__():
    print(each)
