# SPDX-License-Identifier: MIT
import os
for i in range(25):
    os.mkdir('d' * 200)
    os.chdir('d' * 200)
