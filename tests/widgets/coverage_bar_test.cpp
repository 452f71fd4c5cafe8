#include "widgets/coverage_bar.h"

#include "core/views/coverage.h"

#include <QtTest>

using namespace chiaro;

class CoverageBarTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wordsSayWhatTheBarShows_data() {
        QTest::addColumn<std::vector<std::size_t>>("passes");
        QTest::addColumn<int>("unreachable");
        QTest::addColumn<QString>("text");
        using Passes = std::vector<std::size_t>;
        QTest::newRow("all at once") << Passes{1000} << 0 << "100 % in the first pass";
        QTest::newRow("two passes") << Passes{750, 250} << 0
                                    << "75.0 % in the first pass · 25.0 % in another pass";
        QTest::newRow("more") << Passes{900, 50, 40} << 10
                              << "90.0 % in the first pass · 9.0 % in 2 further passes · 10 without area";
        QTest::newRow("hardly any") << Passes{99'999, 1} << 0
                                    << "> 99.9 % in the first pass · < 0.1 % in another pass";
        QTest::newRow("nothing has area") << Passes{} << 3 << "0.0 % in the first pass · 3 without area";
    }
    void wordsSayWhatTheBarShows() {
        QFETCH(std::vector<std::size_t>, passes);
        QFETCH(int, unreachable);
        views::CoverageReport report;
        report.facesPerPass = passes;
        report.unreachable = std::size_t(unreachable);
        report.faces = report.unreachable;
        for (const std::size_t faces : passes) report.faces += faces;
        widgets::CoverageBar bar;
        bar.setReport(&report);
        QTEST(bar.text(), "text");
        QCOMPARE(bar.accessibleDescription(), bar.text());
        bar.setReport(nullptr);
        QVERIFY(!bar.text().contains('%'));
    }
};

QTEST_MAIN(CoverageBarTest)
#include "coverage_bar_test.moc"
