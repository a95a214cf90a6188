// Formats.h - every file format: how it is recognised and who reads it. A new format is a file
// FormatName.cpp with these two functions, declared here, and a line in the table of Formats.cpp.
#pragma once
#include "InputFile.h"

#include <fbrdf/sources/OpenSource.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf {

/// What a reader is given. The file may outlive the call inside `evaluate` or `stream`.
struct FileRequest {
    std::shared_ptr<const InputFile> file;
    std::string choice;  ///< what followed '@' or '#' in the specification; empty for the default
    SourceOptions options;
};

struct Format {
    const char* name;                           ///< as in Source::format
    const char* extensions;                     ///< of such files: " csv txt "; "" for none
    const char* sign;                           ///< by what the content is recognised, in words
    bool takesChoice;                           ///< FILE@choice or FILE#choice means something
    bool (*recognises)(const InputFile& file);  ///< by content alone
    Source (*read)(const FileRequest& request);
    /// True for content that might be meant as this format though it is not recognised: the reader
    /// of the extension then tells what is wrong with it. Null for never.
    bool (*resembles)(const InputFile& file);
    /// Materials in a collection, each a row; null for a file that is one data set.
    size_t (*rows)(const InputFile& file) = nullptr;
};

/// All formats, in the order in which they are tried.
const std::vector<Format>& formats();

/// The format of a file. Throws Error(input) when there is none.
const Format& formatOf(const InputFile& file);

bool isCsv(const InputFile& file);
Source readCsv(const FileRequest& request);
bool isCornell(const InputFile& file);
Source readCornell(const FileRequest& request);
bool isMerl(const InputFile& file);
Source readMerl(const FileRequest& request);
bool isNbrdf(const InputFile& file);
Source readNbrdf(const FileRequest& request);
size_t nbrdfRows(const InputFile& file);
bool isNpf(const InputFile& file);
Source readNpf(const FileRequest& request);
size_t npfRows(const InputFile& file);
bool isRgl(const InputFile& file);
Source readRgl(const FileRequest& request);
bool isBinaryColumns(const InputFile& file);
Source readBinaryColumns(const FileRequest& request);
bool isNist(const InputFile& file);
Source readNist(const FileRequest& request);
bool isRt300s(const InputFile& file);
Source readRt300s(const FileRequest& request);
bool isFred(const InputFile& file);
Source readFred(const FileRequest& request);
bool isLumos(const InputFile& file);
Source readLumos(const FileRequest& request);
bool isPab(const InputFile& file);
Source readPab(const FileRequest& request);
bool isLightTools(const InputFile& file);
Source readLightTools(const FileRequest& request);
bool isZemax(const InputFile& file);
Source readZemax(const FileRequest& request);
bool isAlta(const InputFile& file);
Source readAlta(const FileRequest& request);
bool isMitAniso(const InputFile& file);
Source readMitAniso(const FileRequest& request);
bool isSpeos(const InputFile& file);
Source readSpeos(const FileRequest& request);
bool isMbsdf(const InputFile& file);
Source readMbsdf(const FileRequest& request);
bool isFourier(const InputFile& file);
Source readFourier(const FileRequest& request);
bool isXompt(const InputFile& file);
Source readXompt(const FileRequest& request);
bool isPlanarSpectra(const InputFile& file);
Source readPlanarSpectra(const FileRequest& request);
bool isAstm(const InputFile& file);
Source readAstm(const FileRequest& request);
bool isScattered(const InputFile& file);
Source readScattered(const FileRequest& request);
bool isUtia(const InputFile& file);
Source readUtia(const FileRequest& request);
bool isKlems(const InputFile& file);
Source readKlems(const FileRequest& request);
bool isExrTable(const InputFile& file);
Source readExrTable(const FileRequest& request);
bool isPictureTable(const InputFile& file);
Source readPictureTable(const FileRequest& request);

}  // namespace fbrdf
