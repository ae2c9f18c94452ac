// SPDX-License-Identifier: LGPL-2.1-or-later
// offset_benchmarks [--quick | --full | --corpus | --generated | --extension | --methods | --prototype | --memory | --nearest | --projection | --stack] [OUTPUT_FOLDER]
#include "comparison.h"
#include "corpus.h"
#include "extension.h"
#include "methods.h"
#include "nearest.h"
#include "projection.h"
#include "stack.h"

#include <cstring>
#include <fstream>
#include <iostream>

using namespace benchmark;

namespace
{

constexpr const char *usage = R"(offset_benchmarks [MODE] [OUTPUT_FOLDER]
  --quick      generated faces and a sample of real ones against OpenCASCADE (default)
  --full       generated faces and all free-form real ones against OpenCASCADE, prototype cases, memory
  --generated  generated faces against OpenCASCADE
  --corpus     every real face at +-0.1 % and +-1 % of its diagonal, our offsets alone
  --extension  every free-form real face extended by 5 % of its diagonal
  --methods    the default method beside ravi-kumar, generated faces, shipped examples and some real ones
  --prototype  pole counts beside those of the prototype's least squares
  --memory     peak memory at 128x128 poles
  --nearest    nearest points of all free-form real faces against OpenCASCADE, 100,000 a face: hours; started again, it goes
               on behind the faces in OUTPUT_FOLDER's nearest.csv
  --projection every edge of every real face put back onto its face
  --stack      16 and 200 plies on two fuselage panels: time, memory, OpenCASCADE ply by ply
  --nearest-quick  the same of every fifth face, 2,000 a face
Tables go to the standard output, comparison.csv, worst.txt, corpus.csv, extension.csv, nearest.csv and methods.csv into OUTPUT_FOLDER (default: here).
)";

constexpr int quick_stride = 19;

void run_comparison(const std::vector<BaseFace> &faces, const ComparisonPlan &plan, const std::filesystem::path &folder)
{
    const std::vector<Comparison> rows = compare(faces, plan, std::cout);
    print_summary(rows, std::cout);
    write_csv(rows, folder / "comparison.csv");
    std::ofstream worst(folder / "worst.txt");
    print_worst(rows, 25, worst);
}

int run(const std::string &mode, const std::filesystem::path &folder)
{
    ComparisonPlan plan;
    if (mode == "--memory" || mode == "--full")
        print_memory(std::cout);
    if (mode == "--prototype" || mode == "--full")
        print_prototype_cases(std::cout);
    if (mode == "--corpus")
        run_corpus(real_faces(false), folder / "corpus.csv", std::cout);
    if (mode == "--nearest")
        run_nearest(real_faces(true), 100000, folder / "nearest.csv", std::cout);
    if (mode == "--projection")
        run_projection(real_faces(false), false, std::cout);
    if (mode == "--stack")
        run_stacks(std::cout);
    if (mode == "--nearest-quick")
        run_nearest(real_faces(true, 5), 2000, std::nullopt, std::cout);
    if (mode == "--extension")
        run_extension(real_faces(true), folder / "extension.csv", std::cout);
    if (mode == "--methods")
        run_methods(folder / "methods.csv", std::cout);
    if (mode == "--generated")
        run_comparison(generated_faces(), plan, folder);
    if (mode == "--quick" || mode == "--full")
    {
        std::vector<BaseFace> faces = generated_faces();
        if (mode == "--quick")
        {
            plan.runs = 1;
            plan.grid = 60;
            plan.limit_s = 10.0;
        }
        for (BaseFace &face : real_faces(true, mode == "--quick" ? quick_stride : 1))
            faces.push_back(std::move(face));
        run_comparison(faces, plan, folder);
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    std::string mode = "--quick";
    std::filesystem::path folder = ".";
    for (int i = 1; i < argc; ++i)
    {
        if (std::strncmp(argv[i], "--", 2) == 0)
            mode = argv[i];
        else
            folder = argv[i];
    }
    const bool known = mode == "--quick" || mode == "--full" || mode == "--generated" || mode == "--corpus" ||
                       mode == "--extension" || mode == "--prototype" || mode == "--memory" || mode == "--nearest" ||
                       mode == "--projection" || mode == "--stack" || mode == "--nearest-quick" || mode == "--methods";
    if (!known)
    {
        std::cerr << usage;
        return mode == "--help" ? 0 : 2;
    }
    std::filesystem::create_directories(folder);
    return run(mode, folder);
}
