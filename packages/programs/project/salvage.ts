import * as v from 'valibot'
import type { Project } from '../types.ts'
import { keysOf } from './issue.ts'
import { deepest, isReserved, mostBytes, mostParts } from './limits.ts'
import { projectSchema } from './schema.ts'

/** What could be read of a project that is damaged or too much. `lost`: parts of it were cut or left out. */
export interface Salvaged {
  readonly project: Project
  readonly lost: boolean
}

type Part = { [key: string]: unknown } | unknown[]
const isPart = (value: unknown): value is Part => typeof value === 'object' && value !== null

/** So often the schema is asked; one round fixes all that it names. */
const mostRounds = 40

/**
 * Opens what can be opened of something that `parseProject` refuses: what is too long is cut, what is too deep or no part
 * of a project is left out, and what every project needs comes from `fallback`.
 * @returns null where nothing of a project is in it
 */
export function salvageProject(data: unknown, fallback: Project): Salvaged | null {
  if (!isPart(data) || Array.isArray(data) || ![1, 2, 3, 4, 5].includes(data['botgarten'] as number))
    return null
  const fixer = new Fixer()
  const draft = fixer.copy(data)
  if (!draft) return null
  const { botgarten, programs, world } = fallback
  for (let round = 0; round < mostRounds; round += 1) {
    if (isPart(draft['programs']) && Object.keys(draft['programs']).length === 0) delete draft['programs']
    fixer.fill(draft, { botgarten, name: '', programs, world, brains: {}, assets: {} })
    fixer.fill(draft['world'], {
      ...world,
      floor: { colour: '#FFFFFF' },
      areas: [],
      lines: [],
      obstacles: [],
    })
    fixer.separate(draft)
    const result = v.safeParse(projectSchema, draft)
    if (result.success) return { project: result.output, lost: fixer.lost }
    fixer.fix(draft, result.issues)
  }
  return null
}

class Fixer {
  lost = false

  /** Plain data alone, no deeper and no larger than a project may be. Pictures go first where it is too large. */
  copy(data: { readonly [key: string]: unknown }): { [key: string]: unknown } | null {
    const room = { bytes: mostBytes, parts: mostParts }
    const { assets, ...document } = data
    const draft = this.#copied(document, 0, room) as { [key: string]: unknown } | undefined
    const pictures = this.#copied(assets ?? {}, 1, room)
    if (!draft) return null
    return { ...draft, assets: pictures ?? {} }
  }

  #copied(value: unknown, depth: number, room: { bytes: number; parts: number }): unknown {
    room.parts -= 1
    if (typeof value === 'string') room.bytes -= value.length
    if (room.parts < 0 || room.bytes < 0 || depth > deepest || (isPart(value) && depth === deepest)) {
      if (typeof value === 'string') room.bytes += value.length
      return this.#leaveOut()
    }
    if (!isPart(value)) return value
    if (Array.isArray(value))
      return value.flatMap((one) => {
        const copy = this.#copied(one, depth + 1, room)
        return copy === undefined ? [] : [copy]
      })
    const copy: { [key: string]: unknown } = {}
    for (const [key, one] of Object.entries(value)) {
      const child = isReserved(key) ? this.#leaveOut() : this.#copied(one, depth + 1, room)
      if (child !== undefined) copy[key] = child
    }
    return copy
  }

  #leaveOut(): undefined {
    this.lost = true
    return undefined
  }

  /** Gives it what it must have and has not. */
  fill(part: unknown, presets: { readonly [key: string]: unknown }): void {
    if (!isPart(part) || Array.isArray(part)) return
    for (const [key, preset] of Object.entries(presets)) {
      if (key in part) continue
      part[key] = structuredClone(preset)
      this.lost = true
    }
  }

  /** Of two blocks or things with one id the second is left out, and every robot gets a program that is there. */
  separate(draft: { [key: string]: unknown }): void {
    const programs = isPart(draft['programs']) ? draft['programs'] : {}
    for (const program of Object.values(programs)) this.#separateBlocks(program)
    const world = isPart(draft['world']) ? (draft['world'] as { [key: string]: unknown }) : {}
    const ids = new Set<unknown>()
    for (const kind of ['robots', 'obstacles', 'areas', 'lines']) {
      const list = world[kind]
      if (Array.isArray(list)) world[kind] = this.#unlike(list, ids)
    }
    const [first] = Object.keys(programs)
    const robots = Array.isArray(world['robots']) ? world['robots'] : []
    for (const robot of robots as { program?: unknown }[]) {
      if (first === undefined || !isPart(robot)) continue
      if (typeof robot.program === 'string' && Object.hasOwn(programs, robot.program)) continue
      robot.program = first
      this.lost = true
    }
  }

  #unlike(list: readonly unknown[], ids: Set<unknown>): unknown[] {
    return list.filter((one) => {
      const id = isPart(one) ? (one as { id?: unknown }).id : undefined
      if (typeof id !== 'string') return true
      if (ids.has(id)) {
        this.lost = true
        return false
      }
      ids.add(id)
      return true
    })
  }

  #separateBlocks(program: unknown): void {
    const ids = new Set<unknown>()
    const stacks = isPart(program) ? (program as { stacks?: unknown }).stacks : undefined
    for (const stack of Array.isArray(stacks) ? stacks : []) this.#separateRow(stack, 'blocks', ids)
  }

  #separateRow(owner: unknown, key: string, ids: Set<unknown>): void {
    if (!isPart(owner)) return
    const record = owner as { [key: string]: unknown }
    const row = record[key]
    if (!Array.isArray(row)) return
    const blocks = this.#unlike(row, ids)
    record[key] = blocks
    for (const block of blocks) this.#separateInside(block, ids)
  }

  #separateInside(block: unknown, ids: Set<unknown>): void {
    if (!isPart(block)) return
    const { values, statements } = block as { values?: unknown; statements?: unknown }
    if (isPart(values))
      for (const [name, child] of Object.entries(values)) {
        if (this.#unlike([child], ids).length === 0) delete (values as { [key: string]: unknown })[name]
        else this.#separateInside(child, ids)
      }
    if (isPart(statements))
      for (const name of Object.keys(statements)) this.#separateRow(statements, name, ids)
  }

  /** Cuts what is too long, and takes out of the draft what the schema names, or what lacks what it must have. */
  fix(draft: { [key: string]: unknown }, issues: readonly v.BaseIssue<unknown>[]): void {
    const lists = new Set<unknown[]>()
    for (const issue of issues) this.#mendOne(draft, issue, lists)
    for (const list of lists) list.splice(0, list.length, ...list.filter((one) => one !== gone))
  }

  #mendOne(draft: { [key: string]: unknown }, issue: v.BaseIssue<unknown>, lists: Set<unknown[]>): void {
    const keys = keysOf(issue).map(String)
    const parts = partsOn(draft, keys)
    const owner = parts.at(-2)
    // What it lay in has gone in this round already.
    if (keys.length > 0 && !isPart(owner)) return
    this.lost = true
    const part = parts.at(-1)
    if (issue.type === 'max_length' && typeof part === 'string' && isValue(issue))
      (owner as { [key: string]: unknown })[keys.at(-1)!] = part.slice(0, Number(issue.requirement))
    else if (issue.type === 'max_length' && Array.isArray(part)) part.splice(Number(issue.requirement))
    // Nothing is named: the program and the world do not fit each other.
    else if (keys.length === 0) {
      delete draft['programs']
      delete draft['world']
    }
    // What is not there is missing in what lies around it.
    else if (part === undefined && keys.length > 1) takeOut(parts.at(-3) as Part, keys.at(-2)!, lists)
    else takeOut(owner as Part, keys.at(-1)!, lists)
  }
}

function takeOut(owner: Part, key: string, lists: Set<unknown[]>): void {
  if (!Array.isArray(owner)) delete owner[key]
  else {
    owner[Number(key)] = gone
    lists.add(owner)
  }
}

const gone = Symbol('left out')

/** Is it about a value and not about the key that it stands under? */
const isValue = (issue: v.BaseIssue<unknown>) =>
  issue.path?.at(-1) !== undefined && (issue.path.at(-1) as { origin?: string }).origin !== 'key'

/** The draft itself, and what lies on the way that the keys go. */
function partsOn(draft: unknown, keys: readonly string[]): readonly unknown[] {
  const parts: unknown[] = [draft]
  for (const key of keys) {
    const part = parts.at(-1)
    parts.push(isPart(part) ? (part as { [key: string]: unknown })[key] : undefined)
  }
  return parts
}
