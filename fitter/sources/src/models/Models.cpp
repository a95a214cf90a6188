// The list of all models; a new one is a file, a declaration in ModelBuild.h, and a line here.
#include "ModelBuild.h"

namespace fbrdf {

const std::vector<Model>& models()
{
    static const std::vector<Model> list = {
        lambertModel(),
        phongModel(),
        blinnPhongModel(),
        lafortuneModel(),
        wardModel(),
        ggxModel(),
        beckmannModel(),
        ashikhminShirleyModel(),
        orenNayarModel(),
        plasticModel(),
        poulinFournierModel(),
        heTorranceModel(),
        disneyModel(),
        sgdModel(),
        abcModel(),
        rpvModel(),
        rossLiModel(),
    };
    return list;
}

const Model* findModel(const std::string& name)
{
    for (const Model& model : models())
        if (model.name == name) return &model;
    return nullptr;
}

}  // namespace fbrdf
