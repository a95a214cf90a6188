// ReportTest.cpp - the content of the page. check_page.py checks that it is well formed.
#include "TestMaterials.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/report/Report.h>
#include <gtest/gtest.h>

#include <limits>

namespace fbrdf {
namespace {

bool has(const std::string& page, const std::string& text)
{
    return page.find(text) != std::string::npos;
}

// Small pictures: the tests look at text.
ReportInput inputFor(const Material& material, const Source& source)
{
    ReportInput input{material, source};
    const auto fit = [&](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(material, wo, wi);
    };
    input.sphereOfFit = renderStandardSphere(fit, 32);
    if (source.evaluate) input.sphereOfData = renderStandardSphere(source.evaluate, 32);
    return input;
}

TEST(Report, HoldsTheNumbersItIsGiven)
{
    const Material material = test::constantMaterial(Vec3f(0.2f));
    const Source source = test::lambertianSource(0.1);
    ReportInput input = inputFor(material, source);
    input.lookups = 2;
    input.seconds = {0.25, 1.75, 0.5};
    input.counts = {123456, 789, 4321};
    input.heldOut.logMedian = 0.03217;
    input.all.cosRms = 0.04318;
    input.physics.albedoMax = 0.6283;
    input.heldOutNote = "5 folds";
    input.command = "fbrdf fit lambert:albedo=0.3";
    const std::string page = reportHtml(input);
    for (const char* text : {"123,456", "789", "4,321", "0.0322", "0.0432", "0.628", "5 folds",
                             "1.75 s", "read 0.25", "lambert:albedo=0.3", "hdio", "constant"})
        EXPECT_TRUE(has(page, text)) << text;
}

TEST(Report, FindsTheErrorsOfTheFitByItself)
{
    const Material material = test::constantMaterial(Vec3f(0.2f));
    const Source source = test::lambertianSource(0.1);
    const std::string page = reportHtml(inputFor(material, source));
    EXPECT_TRUE(has(page, "0.693"));  // ln 2, in every bin
    const Source same = test::lambertianSource(static_cast<double>(0.2f));
    EXPECT_FALSE(has(reportHtml(inputFor(material, same)), "0.693"));
}

TEST(Report, SaysFirstWhereTheFormFailsAndWhatDirectionsAreMissing)
{
    const Material material = test::constantMaterial(Vec3f(0.2f));
    const Source source = test::lambertianSource(0.1);
    ReportInput input = inputFor(material, source);
    input.coverage = Coverage{};
    EXPECT_FALSE(has(reportHtml(input), "class=\"warning\""));
    input.coverage->inPlane = true;
    input.misfits.push_back({25, 50, 0, 5, {true, false, false}, 100, 0.1, 3.0, 0.4});
    const std::string page = reportHtml(input);
    EXPECT_TRUE(has(page, "The form does not fit the data"));
    EXPECT_TRUE(
        has(page, "theta_d 0 to 5 degrees (back towards the light), R: off by a factor of 3"));
    EXPECT_TRUE(has(page, "in the plane of incidence only"));
    EXPECT_LT(page.find("does not fit"), page.find("Standard sphere"));
}

TEST(Report, ListsTheFormsTriedAndMarksTheChosen)
{
    const Material material = test::constantMaterial(Vec3f(0.2f));
    const Source source = test::lambertianSource(0.2);
    ReportInput input = inputFor(material, source);
    EXPECT_FALSE(has(reportHtml(input), "Forms tried"));
    input.trials = {
        {"pqp", "p q p", 6144, 2, 0.5, {{"log_rms", 0.0777}, {"log_median_r", 0.0111}}, false},
        {"hdio", "T1 T2", 3840, 2, 0.25, {{"log_rms", 0.0555}, {"score", 0.0222}}, true}};
    const std::string page = reportHtml(input);
    for (const char* text :
         {"Forms tried", "6,144", "3,840", "0.0777", "0.0555", "score", "0.0222", "is-chosen"})
        EXPECT_TRUE(has(page, text)) << text;
    EXPECT_FALSE(has(page, "0.0111"));  // single channels would make the table too wide
}

TEST(Report, ScatteredDataHaveNoPictureAndNoImageErrors)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    const Source source = test::scatteredSource(0.5f);
    const std::string page = reportHtml(inputFor(material, source));
    EXPECT_TRUE(has(page, "no picture of them"));
    EXPECT_TRUE(has(page, "34 rows of the data"));
    EXPECT_FALSE(has(page, "PSNR"));
    EXPECT_FALSE(has(page, "Standard sphere, data"));
}

TEST(Report, CountsWhatBecameOfTheRows)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    Source source = test::scatteredSource(0.5f);
    source.report.given = 7654321;
    ReportInput input = inputFor(material, source);
    EXPECT_TRUE(has(reportHtml(input), "7,654,321"));
    input.rows = SampleReport{};
    input.rows->given = 8765432;  // as counted from a stream
    EXPECT_TRUE(has(reportHtml(input), "8,765,432"));
}

TEST(Report, EscapesHostileNames)
{
    Material material = test::constantMaterial(Vec3f(0.5f));
    material.name = "<script>alert(1)</script>";
    material.notes["\"><img src=x onerror=alert(2)>"] = "]]>&\xFF";
    Source source = test::lambertianSource(0.5);
    source.description = "<iframe>";
    ReportInput input = inputFor(material, source);
    input.command = "</pre><script>";
    input.trials = {{"<b>", "<i>", 1, 1, 1.0, {{"<u>", 1.0}}, true}};
    const std::string page = reportHtml(input);
    for (const char* text : {"<script", "<iframe", "<img src=x", "<i>", "<u>"})
        EXPECT_FALSE(has(page, text)) << text;
    EXPECT_TRUE(has(page, "&lt;script&gt;alert(1)"));
}

TEST(Report, ShowsWhatIsNotANumberAsADash)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    const Source source = test::lambertianSource(0.5);
    ReportInput input = inputFor(material, source);
    input.heldOut.logRms = std::numeric_limits<double>::quiet_NaN();
    const std::string page = reportHtml(input);
    EXPECT_FALSE(has(page, "nan"));
    EXPECT_TRUE(has(page, "\xE2\x80\x93"));
}

TEST(Report, EqualFitsGiveEqualPages)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    const Source source = test::scatteredSource(0.4f);
    EXPECT_EQ(reportHtml(inputFor(material, source)), reportHtml(inputFor(material, source)));
}

TEST(Report, SaysWhereItCannotWrite)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    const Source source = test::scatteredSource(0.4f);
    try {
        writeReport(inputFor(material, source), "no-such-folder/report.html");
        FAIL() << "wrote into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::output);
    }
}

}  // namespace
}  // namespace fbrdf
