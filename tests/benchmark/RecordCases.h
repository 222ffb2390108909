// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The films of the benchmark, and the arguments for the peer that encodes the same. Called by
/// RecordMain.cpp.
namespace bench
{

struct RecordCase
{
    const char* name;
    const char* what;  ///< in a few words
    const char* scene; ///< as `boxreel record` knows it
    std::int64_t frames = 600;
    int width = 1280;              ///< [px]
    int height = 720;              ///< [px]
    double from = 0.0;             ///< simulated before the first frame [s]
    bool isPictures = false;       ///< PNG files instead of an MP4
    std::int64_t movingFrames = 0; ///< of a film of the same scene from its start; 0: not made
    std::int64_t longFrames = 0;   ///< of a longer film of the same; 0: not made
    bool onlyNamed = false;        ///< made only when it is named
};

const std::vector<RecordCase>& AllRecordCases();

/// Returns the case with other films. 0 frames or a width of 0 keep its own.
RecordCase Resized(RecordCase info, std::int64_t frames, int width, int height);

/// A film of a case, and the words that make it.
struct Film
{
    const char* role;   ///< "boxreel", "start", …: what tells films of a case apart
    const char* method; ///< as tables name it
    std::int64_t frames = 0;
    std::string path; ///< of pictures with #### for the number
    std::vector<std::string> words;
    bool isOfRaw = true; ///< shows the time that the raw frames show
};

/// Those of boxreel and of its peers. `program` is boxreel, `helper` this program; films and raw
/// frames lie in `folder`.
std::vector<Film> FilmsOf(const RecordCase& info, const std::string& program,
                          const std::string& helper, const std::string& folder);

/// Returns the arguments after `raw`, `immediate` and others that select the film.
std::vector<std::string> TakeWords(const RecordCase& info, std::int64_t frames);

/// The words that check it; of another time than the raw frames no frame is compared.
std::vector<std::string> CheckWords(const RecordCase& info, const Film& film,
                                    const std::string& helper, const std::string& folder);

/// The words that run ffmpeg: the encoder and the settings of `boxreel record`. `input` is a file
/// of bare pixels or "pipe:0"; `film` ends in .mp4, or in .png with #### for the number.
std::vector<std::string> EncoderWords(int width, int height, const std::string& input,
                                      bool isUpsideDown, const std::string& film);

} // namespace bench
