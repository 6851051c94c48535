import { existsSync, globSync, readdirSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/learning'
import { createLab, type CheckResult } from '@botgarten/lab'
import { check, parseProject } from '@botgarten/programs'
import { paintFloor, readPng, TICKS_PER_SECOND, type World } from '@botgarten/simulation'
import { readMap, withLearnedWay } from '@botgarten/maps'
import { describe, expect, it } from 'vitest'
import { cardDocument, cardProject, readCard, readCardText, type CardProgram } from './index.ts'

addBlocks(learning)

// Every card and every world is held to the same rules merely because it is there.
const content = join(import.meta.dirname, '../../content')
const read = (...path: string[]): unknown => JSON.parse(readFileSync(join(...path), 'utf8'))

const folders = globSync(join(content, 'cards/*/*/card.json')).sort().map(dirname)
const ids = folders.map((folder) => basename(folder).replace(/^\d+-/, ''))
const languages = globSync(join(content, 'words/*/app.json')).map((file) => basename(dirname(file)))
type Named = { readonly [id: string]: string | undefined }

const mapNamed = (id: string) => readMap(readFileSync(join(content, 'maps', id, 'map.svg'), 'utf8')).map

function runOf(folder: string, file: string, start: number): readonly CheckResult[] {
  const card = readCard(read(folder, 'card.json'))
  const world = read(content, 'worlds', card.world, 'world.json') as World
  const document = withLearnedWay(
    cardDocument(world, card, read(folder, file) as CardProgram, start),
    mapNamed,
  )
  const lab = createLab()
  lab.load(document, floorOf(document.world), { seed: 1, checks: card.checks })
  lab.start()
  const seconds = Math.max(
    card.playground === 'q-learning' ? 180 : 60,
    ...card.checks.map((one) => one.seconds),
  )
  lab.advance(seconds * TICKS_PER_SECOND)
  return lab.view().checks
}

function floorOf(world: World) {
  if (!('asset' in world.floor)) return paintFloor(world)
  return paintFloor(world, readPng(readFileSync(join(content, world.floor.asset.replace('content:', '')))))
}

describe.each(folders)('the card in %s', (folder) => {
  const card = readCard(read(folder, 'card.json'))
  const world = read(content, 'worlds', card.world, 'world.json') as World
  const starts = card.starts.map((_, start) => start)
  const wrong = readdirSync(join(folder, 'wrong'))

  it('is named like its folder, and its next card is there', () => {
    expect(basename(folder)).toMatch(new RegExp(`^\\d\\d-${card.id}$`))
    if (card.next !== null) expect(ids).toContain(card.next)
  })

  it('a card beside it is its equal in blocks; its weights solve it, from where its robot starts', () => {
    if (!card.beside) return
    const other = folders[ids.indexOf(card.beside.card)]!
    const { programs, brains } = read(other, 'solution.json') as CardProgram
    expect(programs).toEqual((read(folder, 'solution.json') as CardProgram).programs)
    const weights = Object.entries(brains).map(([id, brain]) => [id, brain.weights])
    expect(card.beside.weights).toEqual(Object.fromEntries(weights))
    expect(card.beside.pose).toEqual(readCard(read(other, 'card.json')).starts[0])
  })

  it.each(languages)('has all its words in "%s"', (language) => {
    const { title, hints, checks } = readCardText(readFileSync(join(folder, `${language}.md`), 'utf8'))
    expect(title.length).toBeGreaterThan(0)
    expect(hints).toHaveLength(3)
    expect(Object.keys(checks)).toEqual(card.checks.map(({ id }) => id))
  })

  it.each(['start.json', 'solution.json', ...wrong.map((file) => join('wrong', file))])(
    '%s is a project that can run',
    (file) => {
      const project = cardProject(world, card, read(folder, file) as CardProgram, card.id)
      expect(parseProject(JSON.parse(JSON.stringify(project)) as unknown)).toMatchObject({ card: card.id })
      const robot = project.world.robots[0]!
      expect(check(project.programs[robot.program]!, robot.config).filter(({ stops }) => stops)).toEqual([])
    },
  )

  it.each(starts)('the solution passes every check from start pose %i', (start) => {
    expect(runOf(folder, 'solution.json', start).filter(({ passed }) => !passed)).toEqual([])
  })

  it('has at least three typical wrong answers', () => expect(wrong.length).toBeGreaterThanOrEqual(3))

  it.each(wrong)('the wrong answer %s is refused: already from the first start pose', (file) => {
    expect(runOf(folder, join('wrong', file), 0).every(({ passed }) => passed)).toBe(false)
  })

  it('the start is not solved yet', () => {
    for (const start of starts)
      expect(runOf(folder, 'start.json', start).every(({ passed }) => passed)).toBe(false)
  })
})

describe.each(globSync(join(content, 'worlds/*/world.json')))('the world in %s', (path) => {
  const world = read(path) as World

  it('has a floor that is there and can be read', () => {
    const floor = floorOf(world)
    expect(floor.width / floor.height).toBeCloseTo(world.size.width / world.size.height, 3)
  })

  it('has its things on the floor and ids that name one thing each', () => {
    const things = [...world.obstacles, ...world.robots]
    expect(new Set(things.map(({ id }) => id)).size).toBe(things.length)
    for (const { pose } of things) {
      expect(pose.x > 0 && pose.x < world.size.width && pose.y > 0 && pose.y < world.size.height).toBe(true)
    }
  })

  it('keeps the drawing from which its floor was made', () => {
    expect(existsSync(join(dirname(path), 'floor.svg'))).toBe('asset' in world.floor)
  })

  it.each(languages)('has a name in "%s"', (language) => {
    const { worldName } = read(content, 'words', language, 'worlds.json') as { worldName: Named }
    expect(worldName[basename(dirname(path))]).toMatch(/\S/)
  })
})
