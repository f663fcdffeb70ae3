// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: words and records of 8 bytes at places that are lanes
// of a vector.
// Needs: gathers.h, vectors-inl.h, a tag DI of int32_t.

/// Whether the instruction set has gathers: where it has none, Highway's stand-in is as quick as
/// loads.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
constexpr bool has_gathers = true;
#else
constexpr bool has_gathers = false;
#endif

template <class Tag>
HWY_INLINE hn::Vec<Tag> load_words(const char* from, Tag, hn::Vec<Tag> places) {
    if constexpr (hn::MaxLanes(Tag()) == 2) {
        const hn::CappedTag<int32_t, 1> one;
        const int64_t both = hn::GetLane(hn::BitCast(hn::Repartition<int64_t, Tag>(), places));
        const auto at = [&](int64_t place) HWY_ATTR {
            return hn::LoadU(one, reinterpret_cast<const int32_t*>(from + 8 * place));
        };
        return hn::Combine(Tag(), at(both >> 32), at(int32_t(both)));
    } else {
        const hn::Half<Tag> half;
        const auto lower = load_words(from, half, hn::LowerHalf(half, places));
        return hn::Combine(Tag(), load_words(from, half, hn::UpperHalf(half, places)), lower);
    }
}

/// Records of two words, a lane each: those of even lanes side by side, and those of odd lanes,
/// from where words come to their lanes without leaving their 64 bits.
struct TwoWords {
    using D64 = hn::Repartition<uint64_t, DI>;
    hn::Vec<D64> even, odd;

    HWY_INLINE hn::Vec<DI> first() const {
        return hn::OddEven(hn::BitCast(DI(), hn::ShiftLeft<32>(odd)), hn::BitCast(DI(), even));
    }
    HWY_INLINE hn::Vec<DI> second() const {
        return hn::OddEven(hn::BitCast(DI(), odd), hn::BitCast(DI(), hn::ShiftRight<32>(even)));
    }
};

/// The records at from + 8 * a and at from + 8 * b.
HWY_INLINE auto load_two(const char* from, int64_t a, int64_t b) {
    const hn::CappedTag<uint64_t, 1> one;
    const auto at = [&](int64_t place) HWY_ATTR {
        return hn::LoadU(one, reinterpret_cast<const uint64_t*>(from + 8 * place));
    };
    return hn::Combine(hn::CappedTag<uint64_t, 2>(), at(b), at(a));
}

/// Of places that are two a lane: the records of all lower halves, and those of all upper ones.
template <class Tag>
HWY_INLINE void load_records(const char* from, Tag, hn::Vec<Tag> places, hn::Vec<Tag>& even,
                             hn::Vec<Tag>& odd) {
    if constexpr (hn::MaxLanes(Tag()) == 2) {
        const auto a = int64_t(hn::ExtractLane(places, 0)), b = int64_t(hn::ExtractLane(places, 1));
        even = load_two(from, int32_t(a), int32_t(b));
        odd = load_two(from, a >> 32, b >> 32);
    } else {
        const hn::Half<Tag> half;
        hn::Vec<hn::Half<Tag>> evens[2], odds[2];
        load_records(from, half, hn::LowerHalf(half, places), evens[0], odds[0]);
        load_records(from, half, hn::UpperHalf(half, places), evens[1], odds[1]);
        even = hn::Combine(Tag(), evens[1], evens[0]);
        odd = hn::Combine(Tag(), odds[1], odds[0]);
    }
}

HWY_INLINE TwoWords load_copied(const uint64_t* records) {
    const TwoWords::D64 d64;
    return {hn::LoadU(d64, records), hn::LoadU(d64, records + hn::Lanes(d64))};
}

/// What stands from `from` on, 8 bytes a place. By gathers or a load each, whichever the processor
/// does sooner.
class Places {
public:
    explicit HWY_INLINE Places(const void* from)
        : m_from(static_cast<const char*>(from)), m_gather(!has_gathers || gathers_are_quick()) {}

    /// The int32_t `byte` after each place, a lane each.
    HWY_INLINE hn::Vec<DI> words(int byte, hn::Vec<DI> places) const {
        const char* const from = m_from + byte;
        if (!m_gather)
            return load_words(from, DI(), places);
        // By an index: 32 bits have no room for the offset in bytes of more than 2^26 pixels'
        // sites.
        return hn::GatherIndex(DI(), reinterpret_cast<const int32_t*>(from),
                               hn::ShiftLeft<1>(places));
    }

    /// The records at the places, which are not negative.
    HWY_INLINE TwoWords records(hn::Vec<DI> places) const {
        const TwoWords::D64 d64;
        const auto two = hn::BitCast(d64, places);
        TwoWords records;
        if (!m_gather) {
            load_records(m_from, d64, two, records.even, records.odd);
        } else {
            const auto* const all = reinterpret_cast<const uint64_t*>(m_from);
            const auto gather = [&](auto index) HWY_ATTR {
                return hn::GatherIndex(d64, all,
                                       hn::BitCast(hn::RebindToSigned<TwoWords::D64>(), index));
            };
            records.even = gather(hn::And(two, hn::Set(d64, 0xffffffffu)));
            records.odd = gather(hn::ShiftRight<32>(two));
        }
        return records;
    }

    /// Copy the records at each of n places, whole vectors of lanes, as load_copied() reads them.
    HWY_INLINE void copy_records(const int* places, size_t n, uint64_t* to) const {
        const size_t lanes = hn::Lanes(DI());
        if (has_gathers && m_gather) {
            const TwoWords::D64 d64;
            for (size_t i = 0; i < n; i += lanes) {
                const TwoWords found = records(hn::LoadU(DI(), places + i));
                hn::StoreU(found.even, d64, to + i);
                hn::StoreU(found.odd, d64, to + i + lanes / 2);
            }
            return;
        }
        const hn::CappedTag<uint64_t, 2> two;
        for (size_t i = 0; i < n; i += lanes)
            for (size_t k = 0; k < lanes; k += 4) {
                const int* const four = places + i + k;
                hn::StoreU(load_two(m_from, four[0], four[2]), two, to + i + k / 2);
                hn::StoreU(load_two(m_from, four[1], four[3]), two, to + i + (lanes + k) / 2);
            }
    }

private:
    const char* m_from;
    bool m_gather;
};
