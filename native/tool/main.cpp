// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line program over the core: reads a model, draws it, and prints its statistics.
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <tool/options.h>
#include <tool/read_model.h>
#include <tool/statistics.h>

#include <fovea/base/check.h>
#include <fovea/base/files.h>
#include <fovea/base/threads.h>

int main(int count, char** words) {
    using namespace fovea;
    using namespace fovea::draw;
    const tool::Options options = tool::parse(count, words);
    try {
        limit_threads(options.threads);
        const tool::Model model = tool::read_model(options.model);
        const style::Style style =
            options.style.empty() ? tool::style_of(options.lines) : tool::read_style(options.style);
        Frame frame = tool::frame_of(model, options.camera, style, options.assets);
        vector::Drawing drawing;
        const std::optional<vector::Kind> vectors = tool::vectors_of(options.output);
        if (options.output.empty()) {
            frame.see();
        } else if (vectors) {
            drawing = tool::write_vectors(frame, options.vectors, *vectors, options.output);
        } else {
            frame.picture();
            tool::write_png(frame, options.output);
        }
        nlohmann::ordered_json found = tool::statistics(model, frame);
        if (vectors) found["vectors"] = tool::statistics(drawing);
        // Names of files need not be UTF-8.
        std::cout << found.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n' << std::flush;
        check(std::cout.good(), "the statistics could not be printed");
        return 0;
    } catch (const std::bad_alloc&) {
        std::cerr << "fovea_tool: memory is too small for " << base::name_of(options.model)
                  << ": simplify it, or lower --size\n";
    } catch (const std::exception& problem) {
        std::cerr << "fovea_tool: " << problem.what() << "\n";
    }
    return 1;
}
