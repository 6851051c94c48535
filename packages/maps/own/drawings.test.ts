import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { isMap } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { cleanDrawing } from '../clean.ts'
import { openMap } from './index.ts'

const folder = join(import.meta.dirname, '..', 'reference', 'drawings')
const drawing = (program: string) => readFileSync(join(folder, `${program}.svg`), 'utf8')
const opened = (program: string) => {
  const { map, ...rest } = openMap(drawing(program), 'mine')
  if (map === null) throw new Error(JSON.stringify(rest))
  return { map, ...rest } as Extract<ReturnType<typeof openMap>, { picture: unknown }>
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

test('a drawing with names that are nearly right is refused, and each is named', () => {
  const { map, ...rest } = openMap(svg(`${rect}<circle id="node_0" r="3"/>`), 'mine')
  expect(map).toBeNull()
  expect(rest).toMatchObject({
    problems: [{ kind: 'noStations' }, { kind: 'strangeId', facts: { name: 'node_0' } }],
  })
})
