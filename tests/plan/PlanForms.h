// PlanForms.h - forms of every kind that plans distinguish.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>
#include <vector>

namespace fbrdf {

/// a + b with the tables of both.
inline Form sum(Form a, const Form& b)
{
    const int offset = static_cast<int>(a.tables.size());
    a.name += "+" + b.name;
    a.tables.insert(a.tables.end(), b.tables.begin(), b.tables.end());
    for (Term term : b.terms) {
        for (Factor& factor : term.factors) factor.table += offset;
        a.terms.push_back(term);
    }
    return a;
}

inline Axis axis(int size)
{
    return {size, {}};
}

/// A single table over (theta_i, theta_o), as a diffuse term has it.
inline Form formIo()
{
    Form form{"io", {{"D", GridDomain{{axis(4), axis(4)}, true}}}, {}};
    form.terms = {{{{0, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}}};
    return form;
}

/// Four look-ups that depend on the light and two that do not.
inline Form formWide()
{
    Form form = formPqp(4, 1.0);
    form.name = "wide";
    form.tables.push_back({"g", GridDomain{{axis(4)}}});
    for (const Angle angle : {Angle::theta_h, Angle::theta_d, Angle::theta_o})
        form.terms[0].factors.push_back({2, std::vector<Angle>{angle}});
    return form;
}

/// A form of one table, in uniforms.
inline Form formUniform()
{
    Form form{"uniform", {{"u", GridDomain{{axis(8)}}, true}}, {}};
    form.terms = {
        {{{0, std::vector<Angle>{Angle::theta_o}}, {0, std::vector<Angle>{Angle::theta_i}}}}};
    return form;
}

inline std::vector<Form> allForms()
{
    const Form pqp = formPqp(8, 1.0), pqpr = formPqpr(8, 0.5, 16), hdio = formHdio({8, 8, 8});
    return {pqp,
            pqpr,
            hdio,
            formIo(),
            formWide(),
            formUniform(),
            sum(formIo(), pqp),
            sum(pqp, formIo()),
            sum(pqp, pqpr),
            sum(sum(pqp, pqpr), hdio),
            sum(formUniform(), pqp),
            sum(formWide(), formWide()),
            sum(formUniform(), formIo())};
}

}  // namespace fbrdf
