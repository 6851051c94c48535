import * as english from 'blockly/msg/en'
import { describe, expect, it } from 'vitest'
import de from '../../../../../../content/words/de/blockly.json'
import en from '../../../../../../content/words/en/blockly.json'

const original = english as unknown as Readonly<Record<string, string>>
const placeholders = (text: string) => (text.match(/%\d/g) ?? []).sort()
const isWords = (key: string, text: string) =>
  !/_HUE$|HELPURL$|_SYMBOL$|^MATH_TRIG_[A-Z]+$|^LOGIC_NULL$/.test(key) && text !== ''
/** Keys of the keyboard and screen-reader support. */
const spoken =
  /^(ANNOUNCE|ARIA|BLOCK_LABEL|BUBBLE_LABEL|FIELD_LABEL|ICON_LABEL|INPUT_LABEL|KEYBOARD_NAV|SCREENREADER|SHORTCUTS|WORKSPACE_(CONTENTS|LABEL|ROLE|SEARCH))/

describe("Blockly's words", () => {
  it('are its own in English', () => {
    const told = Object.fromEntries(Object.keys(en).map((key) => [key, original[key]]))
    expect(en).toEqual(told)
  })

  it('have the same keys in German', () => {
    expect(Object.keys(de)).toEqual(Object.keys(en))
  })

  it('have the same placeholders in German', () => {
    for (const [key, text] of Object.entries(en)) {
      expect([key, placeholders(de[key as keyof typeof de])]).toEqual([key, placeholders(text)])
    }
  })

  it('hold every key of the keyboard and the screen reader', () => {
    const keys = Object.keys(original).filter((key) => spoken.test(key) && isWords(key, original[key]!))
    expect(keys.filter((key) => !(key in en))).toEqual([])
  })

  it('are German in German', () => {
    const same = Object.entries(en).filter(([key, text]) => de[key as keyof typeof de] === text)
    const alike = [
      '%1 of %2',
      'Alt',
      'ChromeOS',
      'Linux',
      'macOS',
      'Windows',
      'Text',
      'text',
      'Name',
      'OK',
      'Pause',
      'e',
      'plus',
      'minus',
    ]
    expect(same.filter(([, text]) => !alike.includes(text))).toEqual([])
  })
})
