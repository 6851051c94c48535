import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { randomPrograms } from '../testing/random-programs.ts'
import { project, sha256 } from '../testing/every-part.ts'
import { parseProject, ProjectError, writeProject, type ProjectReason } from '../index.ts'
import { pathsIn, replaced } from '../testing/paths.ts'

function reasonOf(source: unknown): ProjectReason | 'accepted' {
  try {
    parseProject(source)
    return 'accepted'
  } catch (error) {
    if (error instanceof ProjectError) return error.reason
    throw error
  }
}

describe('a project file', () => {
  it('comes back the same, blocks of unknown type included', () => {
    expect(parseProject(writeProject(project))).toEqual(project)
  })

  it('may be data already', () => {
    expect(parseProject(project)).toEqual(project)
    expect(parseProject(project)).not.toBe(project)
  })

  it('holds any program', () => {
    fc.assert(
      fc.property(randomPrograms, (main) => {
        const whole = { ...project, programs: { main } }
        expect(parseProject(writeProject(whole))).toEqual(JSON.parse(JSON.stringify(whole)))
      }),
      { numRuns: 100 },
    )
  })

  it('of the sorting playground has version 5, which earlier versions refuse', () => {
    const { card: _card, ...others } = project
    const sorting = parseProject({ ...others, playground: 'sorting' })
    expect([sorting.playground, sorting.botgarten]).toEqual(['sorting', 5])
    expect(parseProject(writeProject(sorting))).toEqual(sorting)
    expect(parseProject(writeProject({ ...sorting, botgarten: 1 })).botgarten).toBe(5)
    expect(reasonOf({ ...others, playground: 'cooking' })).toBe('notAProject')
  })

  it('leaves out what nobody knows', () => {
    expect(parseProject({ ...project, extra: 1 })).toEqual(project)
  })
})

describe('what is refused, and why', () => {
  it.each([
    ['', 'notJson'],
    ['{', 'notJson'],
    ['<xml/>', 'notJson'],
    ['null', 'notAProject'],
    ['[]', 'notAProject'],
    ['{}', 'notAProject'],
    ['"hello"', 'notAProject'],
    ['{"botgarten":6}', 'newerVersion'],
    ['{"botgarten":1e999}', 'newerVersion'],
    ['{"botgarten":0}', 'notAProject'],
    ['{"botgarten":"1"}', 'notAProject'],
  ] as const)('%s: %s', (text, reason) => {
    expect(reasonOf(text)).toBe(reason)
  })

  it('a newer version is named', () => {
    expect(() => parseProject('{"botgarten":7}')).toThrow(
      new ProjectError('newerVersion', 'The project has version 7; this Botgarten reads up to 5.', {
        version: 7,
      }),
    )
  })

  it('the message names a robot without a program', () => {
    const other = replaced(project, ['world', 'robots', '0', 'program'], 'other')
    expect(() => parseProject(other)).toThrow('A robot has a program that is not there.')
  })

  it('the message says where', () => {
    const smaller = replaced(project, ['world', 'size', 'width'], -1)
    expect(() => parseProject(smaller)).toThrow(/world\.size\.width/)
  })

  it.each([
    ['two blocks with one id', 'programs.main.stacks.0.blocks.1.id', 'a'],
    ['an id that reaches into every object', 'programs.main.stacks.0.blocks.1.id', '__proto__'],
    ['two things with one id', 'world.areas.0.id', 'bo'],
    ['a robot without its program', 'world.robots.0.program', 'other'],
    ['a robot whose program is a word of every object', 'world.robots.0.program', 'toString'],
    ['a picture outside the product', 'world.floor.asset', 'content:../../etc/passwd'],
    ['a picture from elsewhere', 'world.floor.asset', 'https://example.org/x.png'],
    ['an asset that is no base64', `assets.${sha256}.base64`, '<svg>'],
    ['a noise above 100', 'world.robots.0.config.noise', 101],
    ['a delay above 60 ticks', 'world.robots.0.config.delay', 61],
    ['a delay of half a tick', 'world.robots.0.config.delay', 0.5],
    ['a motor that hardly turns', 'world.robots.0.config.strength', { left: 0.4, right: 1 }],
    ['a sensor nobody knows', 'world.robots.0.config.sensors.1.kind', 'nose'],
    [
      'a sorting with a key that reaches into every object',
      'sorting',
      JSON.parse('{"version":1,"__proto__":{}}'),
    ],
    ['a world without size', 'world.size.width', 0],
    ['a world without a robot', 'world.robots', []],
  ])('%s', (_what, path, value) => {
    expect(reasonOf(replaced(project, path.split('.'), value))).toBe('notAProject')
  })

  it('numbers without end', () => {
    expect(reasonOf(writeProject(project).replace('0.8', '1e999'))).toBe('notAProject')
  })
})

describe('hostile files', () => {
  it('with four robots are taken, with five they are not', () => {
    const [robot] = project.world.robots
    const robots = (count: number) =>
      Array.from({ length: count }, (_, index) => ({ ...robot!, id: `robot${index}` }))
    const reason = (count: number) =>
      reasonOf({ ...project, world: { ...project.world, robots: robots(count) } })
    expect([reason(4), reason(5)]).toEqual(['accepted', 'notAProject'])
  })

  it('of more than 5 MB are too big, in bytes', () => {
    expect(reasonOf(' '.repeat(5_000_001))).toBe('tooBig')
    expect(reasonOf(JSON.stringify('ä'.repeat(2_500_001)))).toBe('tooBig')
    expect(reasonOf(['x'.repeat(3e6), 'x'.repeat(3e6)])).toBe('tooBig')
  })

  it('of a million parts are too big', () => {
    expect(reasonOf(`[${'0,'.repeat(1_000_000)}0]`)).toBe('tooBig')
  })

  it('nested without end are refused, not followed', () => {
    expect(reasonOf('['.repeat(100_000) + ']'.repeat(100_000))).toBe('notAProject')
    const round: { self?: unknown } = {}
    round.self = round
    expect(reasonOf(round)).toBe('notAProject')
  })

  it('blocks in blocks may go as deep as the limit', () => {
    const nest = (depth: number): object =>
      depth === 0 ? { id: 'n0', type: 'x' } : { id: `n${depth}`, type: 'x', values: { A: nest(depth - 1) } }
    const program = (depth: number) => ({
      stacks: [{ x: 0, y: 0, blocks: [nest(depth)] }],
      config: { stacks: [] },
    })
    expect(reasonOf({ ...project, programs: { main: program(290) } })).toBe('accepted')
    expect(reasonOf({ ...project, programs: { main: program(310) } })).toBe('notAProject')
  })

  it.each(['__proto__', 'constructor', 'prototype'])('change no object by a key %s', (key) => {
    const text = writeProject(project).replace('"main":{', `"${key}":{"polluted":true},"main":{`)
    expect(reasonOf(text)).toBe('notAProject')
    expect(({} as { polluted?: boolean }).polluted).toBeUndefined()
  })

  it('of any JSON are accepted or refused with a reason, nothing else', () => {
    fc.assert(
      fc.property(fc.jsonValue({ maxDepth: 6 }), (value) => {
        expect(['accepted', 'notAProject', 'newerVersion']).toContain(reasonOf(JSON.stringify(value)))
      }),
    )
  })

  it('with any one part replaced by anything are accepted or refused with a reason, nothing else', () => {
    const paths = pathsIn(project)
    const foreign = fc.oneof(fc.jsonValue({ maxDepth: 3 }), fc.constantFrom('__proto__', -1, 1e308, {}, []))
    fc.assert(
      fc.property(fc.constantFrom(...paths), foreign, (path, value) => {
        expect(['accepted', 'notAProject', 'newerVersion']).toContain(
          reasonOf(JSON.stringify(replaced(project, path, value))),
        )
      }),
      { numRuns: 1000 },
    )
  })

  it('of any text are refused with a reason', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        expect(['notJson', 'notAProject']).toContain(reasonOf(text))
      }),
    )
  })
})
