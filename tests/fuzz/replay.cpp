// Feeds files to a fuzzer's entry with any compiler: seeds and old findings are tests like others.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> paths;
    for (int i = 1; i < argc; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
            const bool is_picture = entry.path().extension() == ".ppm";  // beside golden scenes
            if (entry.is_regular_file() && !is_picture) paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    if (paths.empty()) {
        std::fputs("replay: no files\n", stderr);
        return 1;
    }
    for (const std::filesystem::path& path : paths) {
        std::printf("%s\n", path.c_str());
        std::fflush(stdout);  // the last line tells which one crashed
        std::ifstream file(path, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
        if (!file) return 1;
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    return 0;
}
