#include "gateway/static_files.hpp"

#include "ciel/types.hpp"
#include "gateway/target.hpp"
#include "support/folder.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <zlib.h>

namespace server::gateway {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

// secret.txt lies outside the client's folder, which contains symbolic links to it.
class Static : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(top_ / "client/assets");
        write("secret.txt", "secret");
        write("client/index.html", "<!doctype html>");
        write("client/assets/index-1a2B3c4D.js", "1");
        write("client/assets/plain.css", "2");
        write("client/.hidden", "3");
        fs::create_symlink(top_ / "secret.txt", top_ / "client/link.txt");
        fs::create_directory_symlink(top_.path(), top_ / "client/up");
        fs::create_symlink("index.html", top_ / "client/start.html");
        fs::create_symlink("nowhere", top_ / "client/broken.html");
    }
    void write(const fs::path& name, const std::string& content) { std::ofstream(top_ / name) << content; }

    static std::string header(const Response& response, const char* name) {
        for (const auto& [other, value] : response.headers)
            if (other == name) return value;
        return {};
    }
    static std::string unpacked(std::string gzip) {
        std::string content(1 << 20, '\0');
        z_stream stream{};
        EXPECT_EQ(inflateInit2(&stream, MAX_WBITS + 16), Z_OK);
        stream.next_in = reinterpret_cast<Bytef*>(gzip.data());
        stream.avail_in = static_cast<uInt>(gzip.size());
        stream.next_out = reinterpret_cast<Bytef*>(content.data());
        stream.avail_out = static_cast<uInt>(content.size());
        EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
        content.resize(stream.total_out);
        inflateEnd(&stream);
        return content;
    }

    const test::Folder top_;
};

TEST_F(Static, FilesAreFoundWithTheirTypes) {
    const StaticFiles files(top_ / "client");
    const struct {
        const char *path, *mime;
        bool immutable;
    } rows[]{
        {"/", "text/html; charset=utf-8", false},
        {"/index.html", "text/html; charset=utf-8", false},
        {"/start.html", "text/html; charset=utf-8", false}, // symbolic link to a file inside the folder
        {"/assets/index-1a2B3c4D.js", "text/javascript; charset=utf-8", true},
        {"/assets/plain.css", "text/css; charset=utf-8", false},
    };
    for (const auto& row : rows) {
        const StaticFile* file = files.find(row.path);
        ASSERT_NE(file, nullptr) << row.path;
        EXPECT_EQ(file->mime, row.mime) << row.path;
        EXPECT_EQ(file->immutable, row.immutable) << row.path;
    }
}

TEST_F(Static, NoPathLeadsOut) {
    const StaticFiles files(top_ / "client");
    for (const char* target : {"/../secret.txt",
                               "/..%2fsecret.txt",
                               "/%2e%2e/secret.txt",
                               "/%2e%2e%2fsecret.txt",
                               "/%252e%252e%252fsecret.txt",
                               "/assets/../../secret.txt",
                               "/assets/%2e%2e/%2e%2e/secret.txt",
                               "/..\\secret.txt",
                               "/..%5csecret.txt",
                               "//secret.txt",
                               "/./../secret.txt",
                               "/link.txt",
                               "/up/secret.txt",
                               "/up",
                               "/broken.html",
                               "/assets",
                               "/assets/",
                               "/index.html/",
                               "/index.html/../../secret.txt",
                               "/INDEX.HTML",
                               "/....//secret.txt",
                               "/%c0%ae%c0%ae/secret.txt"}) {
        const auto parsed = parse_target(target);
        EXPECT_TRUE(!parsed || files.find(parsed->path) == nullptr) << target;
    }
    const std::string absolute = "/" + (top_ / "secret.txt").string();
    EXPECT_EQ(files.find(absolute), nullptr);
    EXPECT_EQ(files.find((top_ / "secret.txt").string()), nullptr);
}

TEST_F(Static, AnUnchangedFileIsNotSentAgain) {
    const StaticFiles files(top_ / "client");
    const StaticFile& file = *files.find("/");
    EXPECT_EQ(file_response(file, "", "").status, 200U);
    EXPECT_EQ(file_response(file, "", "").body, "<!doctype html>");
    for (const std::string& known : {file.etag, "\"other\", " + file.etag, "W/" + file.etag, std::string("*")}) {
        EXPECT_EQ(file_response(file, known, "").status, 304U) << known;
        EXPECT_EQ(file_response(file, known, "").body, "");
    }
    EXPECT_EQ(file_response(file, "\"0000000000000000\"", "").status, 200U);
    EXPECT_NE(file.etag, files.find("/assets/plain.css")->etag);
}

TEST_F(Static, TextIsCompressedForThoseWhoTakeIt) {
    std::string script;
    for (int i = 0; i < 1000; ++i) script += "export const value" + std::to_string(i) + " = 1;\n";
    write("client/script.js", script);
    write("client/picture.png", std::string(10'000, 'x'));
    const StaticFiles files(top_ / "client");
    const StaticFile& file = *files.find("/script.js");
    const Response plain = file_response(file, "", ""), packed = file_response(file, "", "br, gzip");
    EXPECT_EQ(plain.body, script);
    EXPECT_LT(packed.body.size(), script.size() / 4);
    EXPECT_EQ(unpacked(packed.body), script);
    EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
    EXPECT_EQ(header(plain, "Content-Encoding"), "");
    EXPECT_NE(header(packed, "ETag"), header(plain, "ETag"));
    for (const Response& response : {plain, packed, file_response(file, "*", "")})
        EXPECT_EQ(header(response, "Vary"), "Accept-Encoding");
    EXPECT_EQ(file_response(file, header(packed, "ETag"), "gzip").status, 304U);
    EXPECT_EQ(file_response(file, header(plain, "ETag"), "gzip").status, 200U) << "of the other form";
    const Response picture = file_response(*files.find("/picture.png"), "", "gzip");
    EXPECT_EQ(header(picture, "Content-Encoding") + header(picture, "Vary"), "") << "is compressed by itself";
    EXPECT_EQ(file_response(*files.find("/assets/plain.css"), "", "gzip").body, "2") << "would only grow";
}

TEST(AcceptEncoding, IsReadWithItsWeights) {
    for (const char* taken : {"gzip", "GZIP", "x-gzip", "br, gzip", "gzip;q=0.5", "gzip ; q=1.0", "*",
                              "br;q=1, *;q=0.1", "identity;q=0, gzip"})
        EXPECT_TRUE(accepts_gzip(taken)) << taken;
    for (const char* refused :
         {"", "br", "gzip;q=0", "gzip;q=0.000", "*;q=0", "gzip;q=0, *", "gzipped", "gzip;q=x", ",,"})
        EXPECT_FALSE(accepts_gzip(refused)) << refused;
}

TEST_F(Static, OnlyHashedNamesMayBeKeptForGood) {
    const StaticFiles files(top_ / "client");
    const auto cache_control = [&](const char* path) {
        const Response response = file_response(*files.find(path), "", "");
        const auto header = std::find_if(response.headers.begin(), response.headers.end(),
                                         [](const auto& row) { return row.first == "Cache-Control"; });
        return header->second;
    };
    EXPECT_EQ(cache_control("/"), "no-cache");
    EXPECT_EQ(cache_control("/assets/plain.css"), "no-cache");
    EXPECT_EQ(cache_control("/assets/index-1a2B3c4D.js"), "public, max-age=31536000, immutable");
}

TEST_F(Static, AFolderThatIsNoneIsAnError) {
    for (const fs::path& path : {top_ / "absent", top_ / "secret.txt"}) EXPECT_THROW(StaticFiles{path}, Error);
}

} // namespace
} // namespace server::gateway
