//! What is said: every message of the library by its key, once in one way.

use std::collections::BTreeMap;

use forage::kernel::message::sentences;

#[test]
fn a_key_is_said_in_one_way_in_english() {
    let mut said = BTreeMap::new();
    for sentence in sentences() {
        let known = said.insert(sentence.key, (sentence.english, sentence.plurals));
        assert!(known.is_none_or(|known| known == (sentence.english, sentence.plurals)), "{}: {known:?} and {sentence:?}", sentence.key);
    }
    assert!(said.len() > 100, "{} messages", said.len());
}

#[test]
fn keys_are_lower_case_words_joined_by_hyphens() {
    for sentence in sentences() {
        let plain =
            sentence.key.split('-').all(|word| !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit()));
        assert!(plain && sentence.key.contains('-') || sentence.key == "sentences", "{}", sentence.key);
    }
}
