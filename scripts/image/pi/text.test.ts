import { codeInTerminal } from '@botgarten/server/terminal'
import { expect, test } from 'vitest'
import { halved, say, screenText, teacherLink, type Language, type ScreenFacts, type Word } from './text.ts'
import words from './words.json' with { type: 'json' }

const own = '10.42.0.1'
const facts: ScreenFacts = {
  ...{ language: 'en', hotspot: { name: 'Botgarten', password: 'abcd-efgh-jkmn' } },
  ...{ addresses: [own], token: 'secret', started: true, passwordMade: false, room: 20_000, trial: null },
}
const draw = (link: string) => `[${link}]`

test('the first screen says Wi-Fi, password, addresses and the link for the first teacher', () => {
  const text = screenText(facts, own, draw)
  for (const part of [
    'Botgarten',
    'abcd-efgh-jkmn',
    'http://botgarten.local   http://10.42.0.1',
    '7 to 10 devices',
  ])
    expect(text).toContain(part)
  expect(text).toContain(
    '\nhttp://10.42.0.1/teacher/start#secret\n\n[http://10.42.0.1/teacher/start#secret]\n',
  )
})

test('once there is a teacher no link is seen', () => {
  expect(screenText({ ...facts, token: null }, own, draw)).not.toMatch(/teacher/)
})

test('a full card, a cable alone and an update that failed are told', () => {
  const text = screenText({ ...facts, room: 3, addresses: ['192.168.1.7'], trial: 'failed' }, own, draw)
  for (const word of ['full', 'noWifi', 'failed'] as const) expect(text).toContain(say('en', word))
  expect(text).not.toContain('abcd-efgh-jkmn')
  expect(teacherLink(['192.168.1.7'], own, 'x')).toBe('http://192.168.1.7/teacher/start#x')
  expect(screenText({ ...facts, room: 300 }, own, draw)).toContain('300 MB are left')
})

test('a code of half the size has the same modules', () => {
  const code = codeInTerminal('http://10.42.0.1/teacher/start#secret')
  const rows = code.split('\n').filter((row) => row !== '')
  const small = halved(code).split('\n')
  expect(small.length).toBe(Math.ceil(rows.length / 2))
  const dark = (row: number, column: number) => '▀█'.includes(small[row >> 1]![column]!) && row % 2 === 0
  const low = (row: number, column: number) => '▄█'.includes(small[row >> 1]![column]!) && row % 2 === 1
  rows.forEach((row, y) =>
    (row.match(/../gu) ?? []).forEach((module, x) =>
      expect(dark(y, x) || low(y, x), `${x},${y}`).toBe(module === '██'),
    ),
  )
})

test('both languages have every sentence, with the same blanks to fill', () => {
  const blanks = (text: string) => (text.match(/\{\w+\}/g) ?? []).toSorted()
  expect(Object.keys(words.de)).toEqual(Object.keys(words.en))
  for (const word of Object.keys(words.en) as Word[])
    expect(blanks(words.de[word])).toEqual(blanks(words.en[word]))
  expect(Object.keys(words) satisfies string[] as Language[]).toEqual(['de', 'en'])
})
