import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { content } from '@botgarten/content/files'
import { isLong } from '@botgarten/numbers/testing'
import { isMap, type RoadMap } from '@botgarten/programs'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { cleanDrawing } from '../clean.ts'
import { addStation, emptyMap, openMap, writeMap, type OpenedMap } from './index.ts'
import { changedDrawing } from './testing.ts'

const folder = join(import.meta.dirname, '..', 'reference', 'drawings')
const drawing = (program: string) => readFileSync(join(folder, `${program}.svg`), 'utf8')
const opened = (program: string) => {
  const { map, ...rest } = openMap(drawing(program), 'mine')
  if (map === null) throw new Error(JSON.stringify(rest))
  return { map: map as RoadMap, ...rest } as Extract<OpenedMap, { picture: unknown }> & { map: RoadMap }
}
const roads = (program: string) =>
  opened(program).map.roads.map(({ from, to, oneWay }) => `${from}${oneWay ? '→' : '–'}${to}`)

describe('a drawing of another program', () => {
  test.each(readdirSync(folder).filter((file) => file.endsWith('.svg')))(
    '%s opens, and nothing of it is lost or named',
    (file) => {
      const { map, warnings, picture } = opened(file.replace('.svg', ''))
      expect([isMap(map), warnings]).toEqual([true, []])
      // The picture in it is kept.
      expect(picture).toMatch(
        file === 'libreoffice.svg' ? /<path / : /<image [^>]*href="data:image\/png;base64,/,
      )
      expect(picture).not.toMatch(/id="(?:node|path)-|filter=|foreignObject|http:\/\/ns\./)
    },
  )

  test('has the roads that were drawn, one way and both ways', () => {
    expect(roads('inkscape')).toEqual(['0–1', '0→3', '1–2', '3→2'])
    expect(roads('illustrator')).toEqual(['0–1', '0→2', '1→2'])
    expect(roads('figma')).toEqual(['0–1', '1→2'])
  })

  test('has its stations where they are seen', () => {
    // 800 × 500 becomes 1600 × 1000.
    expect(opened('figma').map.stations).toEqual([{ x: 200, y: 760 }, { x: 760, y: 600 }, { x: 1360, y: 800 }]) // prettier-ignore
  })

  test('without names of stations and roads is a picture to draw on', () => {
    for (const program of ['libreoffice', 'powerpoint'])
      expect(opened(program).map).toMatchObject({ name: 'mine', stations: [], roads: [] })
  })
})

const svg = (content: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 160 100">${content}</svg>`
const rect = '<rect width="9" height="9"/>'

describe('of a drawing is taken out, and named,', () => {
  test.each([
    ['script', '<script>alert(1)</script>'],
    ['foreignObject', '<foreignObject><p xmlns="http://www.w3.org/1999/xhtml">x</p></foreignObject>'],
    ['animate', '<rect><animate attributeName="x"/></rect>'],
    ['onload', '<g onload="alert(1)"/>'],
    ['xlink:href', '<image xlink:href="https://example.org/a.png"/>'],
    ['href', '<image href="data:image/svg+xml;base64,AAAA"/>'],
    ['href', '<a href="#x"><rect/></a>'],
    ['style', '<style>@import url(x.css);</style>'],
    ['style', '<style>.a{fill:url(http://example.org/a.svg#a)}</style>'],
    ['style', '<g style="background:url(//example.org)"/>'],
  ])('%s', (name, content) => {
    const cleaned = cleanDrawing(svg(rect + content))
    expect(cleaned).toMatchObject({ removed: [name] })
    const { picture } = cleaned as { picture: string }
    expect(picture).toContain('<rect width="9"')
    expect(picture).not.toMatch(/script|foreign|animate|onload|example|svg\+xml|@import/)
  })

  test('copies that hold copies of themselves', () => {
    const ring =
      '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g><use href="#c"/><circle id="c" r="2"/>'
    const { picture } = cleanDrawing(svg(rect + ring)) as { picture: string }
    expect(picture.match(/<use/g)).toHaveLength(1)
  })
})

test('a drawing of more than 5,000 elements is refused with that number', () => {
  const groups = (count: number) => svg('<g/>'.repeat(count - 1))
  expect(cleanDrawing(groups(5_000))).toHaveProperty('picture')
  expect(cleanDrawing(groups(5_001))).toEqual({
    problem: { kind: 'tooManyElements', facts: { most: 5_000 } },
  })
})

test('a drawing with names that are nearly right is refused, and each is named', () => {
  const { map, ...rest } = openMap(svg(`${rect}<circle id="node_0" r="3"/>`), 'mine')
  expect(map).toBeNull()
  expect(rest).toMatchObject({
    problems: [{ kind: 'noStations' }, { kind: 'strangeId', facts: { name: 'node_0' } }],
  })
})

describe('a drawing of which some letters have changed', () => {
  const own = writeMap([{ x: 200, y: 200 }, { x: 700, y: 300 }].reduce(addStation, emptyMap('own')), 'own') // prettier-ignore
  const files = [...readdirSync(folder).filter((file) => file.endsWith('.svg')).map((file) => drawing(file.replace('.svg', ''))), own] // prettier-ignore
  const mutated = changedDrawing(files)
  const said = (language: string) =>
    (
      JSON.parse(readFileSync(content.path('words', language, 'map-designer.json'), 'utf8')) as {
        design: { problem: object }
      }
    ).design.problem

  test('is read, or refused in a sentence, within 200 ms of work', () => {
    for (const text of fc.sample(mutated, { numRuns: isLong ? 2000 : 20, seed: 2026 })) {
      const before = process.threadCpuUsage()
      const opened = openMap(text, 'mine')
      const { user, system } = process.threadCpuUsage(before)
      expect((user + system) / 1000, text).toBeLessThan(200)
      if (opened.map !== null) expect(isMap(opened.map), text).toBe(true)
      else expect(opened.problems.length, text).toBeGreaterThan(0)
      const kinds = [...(opened.map === null ? opened.problems : []), ...opened.warnings].map(
        ({ kind }) => kind,
      )
      for (const language of ['de', 'en'])
        expect(Object.keys(said(language))).toEqual(expect.arrayContaining(kinds))
    }
  }, 600_000)
})
