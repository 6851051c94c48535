import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Block } from '@botgarten/blocks'
import { project, sha256 } from '../testing/every-part.ts'
import { pathsIn, replaced } from '../testing/paths.ts'
import { parseProject, salvageProject, type Project } from '../index.ts'

const fallback: Project = {
  ...project,
  name: 'fallback',
  programs: { main: { stacks: [], config: { stacks: [] } } },
  world: { ...project.world, size: { width: 50, height: 50 }, obstacles: [], areas: [], lines: [] },
}
const salvaged = (data: unknown) => {
  const found = salvageProject(data, fallback)
  if (found) expect(parseProject(found.project)).toEqual(found.project)
  return found
}
const without = (path: string) => replaced(project, path.split('.'), undefined)

describe('what can be opened of a project', () => {
  it('all of a whole one', () => {
    expect(salvaged(project)).toEqual({ project, lost: false })
  })

  it('a text that is too long is cut, and the rest is untouched', () => {
    const path = 'programs.main.stacks.0.blocks.0.fields.DEBUG'.split('.')
    const { project: opened, lost } = salvaged(replaced(project, path, 'x'.repeat(21_600)))!
    expect(opened).toEqual(replaced(project, path, 'x'.repeat(20_000)))
    expect(lost).toBe(true)
  })

  it('of loops in each other those that are not too deep', () => {
    const loops = (depth: number): Block => ({
      id: `l${depth}`,
      type: 'robControls_loopForever',
      statements: { DO: depth === 1 ? [] : [loops(depth - 1)] },
    })
    const count = (block: Block | undefined): number => (block ? 1 + count(block.statements?.['DO']?.[0]) : 0)
    const main = { stacks: [{ x: 0, y: 0, blocks: [loops(1000)] }], config: { stacks: [] } }
    const { project: opened, lost } = salvaged({ ...project, programs: { main } })!
    expect(count(opened.programs['main']!.stacks[0]!.blocks[0])).toBeGreaterThanOrEqual(197)
    expect(lost).toBe(true)
    expect(opened.world).toEqual(project.world)
  })

  it('a picture that is too large goes, and the program stays', () => {
    const large = { [sha256]: { type: 'image/png', base64: 'A'.repeat(6_000_000) } }
    const { project: opened, lost } = salvaged({ ...project, assets: large })!
    expect(opened).toEqual({ ...project, assets: {} })
    expect(lost).toBe(true)
  })

  it.each([
    ['a thing without its place', 'world.obstacles.0.pose', { obstacles: [] }],
    ['an area of no shape', 'world.areas.0.shape', { areas: [] }],
    ['a line without points', 'world.lines.0.points', { lines: [] }],
    ['a floor that is none', 'world.floor', { floor: { colour: '#FFFFFF' } }],
    ['a world without a size', 'world.size', { size: fallback.world.size }],
    ['a world without a robot', 'world.robots', { robots: fallback.world.robots }],
  ])('%s', (_what, path, world) => {
    const { project: opened, lost } = salvaged(without(path))!
    expect(opened).toEqual({ ...project, world: { ...project.world, ...world } })
    expect(lost).toBe(true)
  })

  it('of two things and two blocks with one id the first', () => {
    const [thing] = project.world.obstacles
    const twice = { ...project, world: { ...project.world, obstacles: [thing, thing] } }
    expect(salvaged(twice)).toEqual({ project, lost: true })
    const { blocks } = project.programs['main']!.stacks[0]!
    const path = 'programs.main.stacks.0.blocks'.split('.')
    expect(salvaged(replaced(project, path, [...blocks, blocks[0]]))).toEqual({ project, lost: true })
    const inside = { ...blocks[1], values: { X: blocks[0] } }
    const { project: opened } = salvaged(replaced(project, path, [blocks[0], inside]))!
    expect(opened.programs['main']!.stacks[0]!.blocks[1]).toEqual({ ...blocks[1], values: {} })
  })

  it('a robot whose program is not there gets one that is', () => {
    expect(salvaged(replaced(project, 'world.robots.0.program'.split('.'), 'nowhere'))).toEqual({
      project,
      lost: true,
    })
  })

  it('where no program is left, that of a fresh start', () => {
    const { project: opened } = salvaged({ ...project, programs: 7 })!
    expect(opened.programs).toEqual(fallback.programs)
    expect(opened.brains).toEqual(project.brains)
  })

  it.each([
    ['a list', []],
    ['nothing', null],
    ['a word', 'botgarten'],
    ['a later version', { ...project, botgarten: 6 }],
    ['no version', without('botgarten')],
  ])('nothing of %s', (_what, data) => {
    expect(salvaged(data)).toBeNull()
  })

  it('no key that reaches into every object, and no circle', () => {
    const hostile = JSON.parse('{"botgarten":1,"name":"x","programs":{"__proto__":{"polluted":true}}}') as object
    expect(salvaged(hostile)!.project.name).toBe('x')
    expect(({} as { polluted?: boolean }).polluted).toBeUndefined()
    const round: { botgarten: number; self?: unknown } = { botgarten: 1 }
    round.self = round
    expect(salvaged(round)!.project.programs).toEqual(fallback.programs)
  }) // prettier-ignore

  it('something that opens, whatever one part was replaced by, with everything that was not near it', () => {
    const paths = pathsIn(project).filter(([first, ...rest]) => first !== 'botgarten' && rest.length > 0)
    const damage = fc.oneof(fc.jsonValue({ maxDepth: 3 }), fc.constantFrom(NaN, {}, [], undefined, 't'.repeat(200_001)))
    fc.assert(
      fc.property(fc.constantFrom(...paths), damage, (path, value) => {
        const { project: opened } = salvaged(replaced(project, path, value))!
        for (const part of ['programs', 'world', 'brains', 'assets'] as const)
          if (part !== path[0]) expect(opened[part]).toEqual(project[part])
      }),
      { numRuns: 2000 },
    )
  }) // prettier-ignore

  it('something that opens or nothing, whatever it is', () => {
    const anything = fc.jsonValue({ maxDepth: 5 })
    const keys = fc.constantFrom('name', 'programs', 'world', 'brains', 'assets', 'q', 'sorting', 'progress')
    fc.assert(
      fc.property(fc.dictionary(keys, anything), (parts) => {
        expect(salvaged({ botgarten: 1, ...parts })).not.toBeNull()
      }),
      { numRuns: 500 },
    )
  })
})
