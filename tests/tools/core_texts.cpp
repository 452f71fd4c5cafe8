// Lists what core says to an artist through the studio's forms and figures, as source that lupdate reads:
// core knows no Qt and marks nothing for translation itself. The translations' check wants every parameter
// table here.

#include "core/base/import.h"
#include "core/gradient/gradient.h"
#include "core/methods/coherence.h"
#include "core/methods/image_based.h"
#include "core/methods/view_aligned.h"
#include "core/methods/view_dependent.h"
#include "core/metrics/frame.h"
#include "core/metrics/study.h"
#include "core/project/comparison_report.h"
#include "core/project/mesh_export.h"
#include "core/project/render_method.h"
#include "core/sample/strip.h"
#include "core/scene/occlusion_params.h"
#include "core/synthesis/levels.h"
#include "core/synthesis/quilting.h"
#include "core/views/planning.h"

#include <cstdio>
#include <set>
#include <string>

using namespace chiaro;

namespace {

std::set<std::string> texts;

template <class Params>
void addTable() {
    for (const ParameterSpec& spec : Params::table().specs()) {
        texts.insert({spec.label, spec.tooltip, spec.unit});
        texts.insert(spec.choices.begin(), spec.choices.end());
    }
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char one : text) {
        if (one == '"' || one == '\\') result += '\\';
        if (one == '\n')
            result += "\\n";
        else
            result += one;
    }
    return result + "\"";
}

}  // namespace

int main() {
    addTable<ImportSettings>();
    addTable<sample::StripParams>();
    addTable<gradient::GradientParams>();
    addTable<synthesis::QuiltParams>();
    addTable<synthesis::LevelParams>();
    addTable<scene::OcclusionParams>();
    addTable<views::ViewParams>();
    addTable<methods::ImageBasedParams>();
    addTable<methods::CoherenceParams>();
    addTable<methods::ViewAlignedParams>();
    addTable<methods::ViewDependentParams>();
    addTable<metrics::MeasureParams>();
    addTable<project::MeshExportParams>();
    for (const project::RenderMethod& method : project::renderMethods()) texts.insert(method.label);
    for (const project::ComparedError& error : project::comparedErrors()) texts.insert(error.name);
    for (const metrics::StudyTexture& texture : metrics::builtInTextures()) texts.insert(texture.name);
    texts.erase("");
    std::puts("const char* const texts[] = {");
    for (const std::string& text : texts)
        std::printf("    QT_TRANSLATE_NOOP(\"Core\", %s),\n", quoted(text).c_str());
    std::puts("};");
}
