import { expect, it } from 'vitest'
import { isOpenRoberta, isProgramFile } from './endings.ts'

it('a program is known by the end of its file’s name', () => {
  expect(['a.xml', 'A.XML', 'a.botgarten', 'a.botgarten.json'].every(isProgramFile)).toBe(true)
  expect(['a.json', 'a.png', 'xml', 'a.xml.png'].some(isProgramFile)).toBe(false)
})

it('Open Roberta’s files are known by name, or by their beginning', () => {
  expect(isOpenRoberta('a.xml', 'whatever')).toBe(true)
  expect(isOpenRoberta('a.txt', '\uFEFF<?xml version="1.0"?>\n<export xmlns="x">')).toBe(true)
  expect(isOpenRoberta('a.json', '{"name":"<export>"}')).toBe(false)
  expect(isOpenRoberta('a.json', '<exporter>')).toBe(false)
})

it('only the first 1000 letters are looked at for that', () => {
  expect(isOpenRoberta('a.txt', `${' '.repeat(992)}<export>`)).toBe(true)
  expect(isOpenRoberta('a.txt', `${' '.repeat(993)}<export>`)).toBe(false)
})
