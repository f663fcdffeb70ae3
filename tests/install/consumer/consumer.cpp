// SPDX-License-Identifier: Apache-2.0
// Calls the two examples of the README, which the test puts beside this file.
#include <string>
#include <vector>

bool enlarge_file(const std::string& in, const std::string& out);
std::vector<float> four_times(const std::vector<float>& rgb, int width, int height);

int main(int argc, char** argv) {
    if (argc != 3 || !enlarge_file(argv[1], argv[2]))
        return 1;
    std::vector<float> grey(3 * 5 * 4, 0.25f);
    for (float value : four_times(grey, 5, 4))
        if (value != 0.25f)
            return 2;
    return 0;
}
