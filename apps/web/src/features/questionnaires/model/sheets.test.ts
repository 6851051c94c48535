import content from 'content:questionnaires'
import { writeFormFile } from '@botgarten/content/questionnaires'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { Sheets } from './sheets.svelte.ts'

beforeEach(() => void freshLocalStorage())
afterEach(() => vi.unstubAllGlobals())

const after = content.forms.find(({ form }) => form.id === 'after')!
const own = { form: { ...after.form, id: 'after-2' }, text: after.text }

test('a form from a file is there on this device, until it is removed; one of the product is refused', () => {
  const sheets = new Sheets()
  expect(sheets.takeFile(writeFormFile(own))).toEqual({ kind: 'form' })
  expect(new Sheets().form('after-2')).toEqual(own)
  expect(sheets.takeFile(writeFormFile(after))).toEqual({ kind: 'refused' })
  sheets.removeForm('after-2')
  expect(new Sheets().form('after-2')).toBeUndefined()
})

test('a form that is saved again replaces the one of its name', () => {
  const sheets = new Sheets()
  sheets.keepForm(own)
  const title = 'After the project day'
  sheets.keepForm({ ...own, text: { en: { ...own.text['en']!, title } } })
  const found = sheets.forms.filter(({ form }) => form.id === 'after-2')
  expect(found.map(({ text }) => text['en']!.title)).toEqual([title])
})

test('sheets of paper are removed for one form, and those of another form stay', () => {
  const sheets = new Sheets()
  for (const [form, n] of [
    ['before', 5],
    ['after', 6],
  ] as const)
    sheets.addPaper({ form, bands: ['5-6'], n, counts: {}, open: {} })
  sheets.removePaper('before')
  expect([sheets.typed('before'), sheets.typed('after')]).toEqual([0, 6])
  expect(new Sheets().typed('after')).toBe(6)
})
