INPUT_1 = "1"
INPUT_2 = "2"
INPUT_3 = "3"
INPUT_4 = "4"
