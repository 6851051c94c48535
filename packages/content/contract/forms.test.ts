import { readFileSync } from 'node:fs'
import { languagesOf } from '@botgarten/messages/folder'
import { draw, stream } from '@botgarten/numbers'
import { describe, expect, it, test } from 'vitest'
import { content } from '../files.ts'
import { gradeOf } from '../items/readability.ts'
import { missingIn, readForm, readFormFile, topics, writeFormFile } from '../questionnaires/index.ts'
import './there.ts'

describe.each(content.forms.map((loaded) => [loaded.form.id, loaded] as const))(
  'the form %s',
  (_, loaded) => {
    const { form, text } = loaded

    it.each(languagesOf(text))('has all its words in "%s"', (language) => {
      expect(missingIn(form, text[language]!)).toEqual([])
    })

    it.each(languagesOf(text))('asks as simply as children of grade 3 read, in "%s"', (language) => {
      const { words } = text[language]!
      const asked = form.items.flatMap(({ id }) => words[id]?.['young'] ?? [])
      const grade = gradeOf(asked.join('\n'), language)
      if (grade !== null) expect(grade).toBeLessThanOrEqual(4)
    })

    it('asks only questions about Bo whose answer the simulation gives', () => {
      for (const item of form.items)
        if (item.kind === 'robot') expect(content.questions.map(({ id }) => id)).toContain(item.question)
    })

    it('is a file that can be read again', () => {
      expect(readFormFile(JSON.parse(writeFormFile(loaded)))).toEqual(loaded)
    })
  },
)

test('every topic has a picture', () => {
  for (const topic of topics) expect(readFileSync(content.pictureOfTopic(topic), 'utf8')).toMatch(/^<svg /)
})

test('the study’s six items stand in its order, with its scale', () => {
  const { form, text } = content.forms.find((one) => one.form.id === 'after')!
  expect(form.items.slice(0, 6).map(({ id }) => id)).toEqual([
    'interest-supervised',
    'ease-supervised',
    'interest-unsupervised',
    'ease-unsupervised',
    'interest-reinforcement',
    'ease-reinforcement',
  ])
  const { words } = text['en']!
  expect([words['interest']!['1'], words['interest']!['5']]).toEqual([
    'very uninteresting',
    'very interesting',
  ])
  expect([words['ease']!['1'], words['ease']!['5']]).toEqual(['very difficult', 'very easy'])
})

test('what is asked about Bo before is asked again after, and after four weeks', () => {
  const asked = content.forms.map(({ form }) => form.items.filter(({ kind }) => kind === 'robot'))
  expect(asked.map((items) => items.length)).toEqual([3, 3, 3])
  expect(asked[1]).toEqual(asked[0])
  expect(asked[2]).toEqual(asked[0])
})

test('a form whose screens leave an item out is refused', () => {
  const { form } = content.forms[0]!
  expect(() => readForm({ ...form, screens: form.screens.slice(1) })).toThrow(/every item once/)
})

test('a form of 40 items is read, and one of 41 is refused', () => {
  const { form } = content.forms[0]!
  const long = (count: number) => {
    const items = Array.from({ length: count }, (_, k) => ({ id: `item-${k}`, kind: 'text' as const }))
    return { ...form, items, screens: [items.map(({ id }) => id)] }
  }
  expect(readForm(long(40)).items).toHaveLength(40)
  expect(() => readForm(long(41))).toThrow(expect.objectContaining({ name: 'ValiError' }))
})

const files = content.forms.map(writeFormFile)

/** A form's file with one letter changed, taken out or doubled. */
function damaged(seed: number): string {
  const state = stream(seed, 'forms')
  const text = files[seed % files.length]!
  const at = Math.floor(draw(state) * text.length)
  const letter = String.fromCharCode(32 + Math.floor(draw(state) * 95))
  const put = [letter, '', text[at]! + letter][Math.floor(draw(state) * 3)]!
  return text.slice(0, at) + put + text.slice(at + 1)
}

test('2,000 damaged forms: each is refused or is one', () => {
  for (let seed = 0; seed < 2000; seed++)
    try {
      const { form, text } = readFormFile(JSON.parse(damaged(seed)))
      for (const one of Object.values(text)) expect(missingIn(form, one)).toEqual([])
    } catch (cause) {
      expect(['ValiError', 'SyntaxError']).toContain((cause as Error).name)
    }
})
