import { languagesOf, type OwnCard } from '../own-card.ts'
import type { Project } from '../types.ts'
import { version as madeWith } from '../version.ts'
import { ProjectError } from './error.ts'
import { refuseBigText, refuseOversize } from './limits.ts'
import { parseProject } from './project.ts'
import { bringsPrograms, fitsWorld, messageOf } from './schema-card.ts'
import { versionOf } from './versions.ts'

/** Version of the file of a card. */
const newest = 1

/**
 * What children get of a card that is being made: its start program in its world, at the first place. `whole`: with the
 * solution and the wrong answers, for colleagues. What is no draft is already what children get.
 */
export function playedFrom(project: Project, whole = false): Project {
  const { ownCard, programs, brains, world, maps, assets, shelf } = project
  if (!ownCard) throw new RangeError('This project is no card.')
  const { draft, start, solution, wrong, text, ...card } = ownCard
  const solved = draft ? { programs, brains } : solution
  const answers = whole && { ...(solved && { solution: solved }), ...(wrong && { wrong }) }
  const from = card.starts[0]!
  const robots = world.robots.map((robot, index) => (index === 0 ? { ...robot, pose: from } : robot))
  const played = {
    ...{ name: project.name, programs: { ...programs, ...(draft && start?.programs) } },
    brains: (draft && start?.brains) ?? brains,
    world: { ...world, robots },
    ownCard: { ...card, text: wholeWords(text), ...answers } satisfies OwnCard,
    ...{ ...(maps && { maps }), ...(shelf && { shelf }), assets },
  }
  return { botgarten: versionOf(played), ...played }
}

/** A language that is begun and not whole stays at home. */
const wholeWords = (text: OwnCard['text']): OwnCard['text'] =>
  Object.fromEntries(languagesOf({ text }).map((language) => [language, text[language]!]))

/** A card as a file: `{botgarten: 'card', version: 1, …}`. `parseCardFile` reads the same project from it. */
export function writeCardFile(project: Project): string {
  const { name, ownCard: card, programs, brains, world, maps, assets, shelf } = project
  return JSON.stringify({
    ...{ botgarten: 'card', version: newest, madeWith, name, card, programs, brains, world },
    ...{ ...(maps && { maps }), ...(shelf && { shelf }), assets },
  })
}

/** Does this say that it is a card? */
export const isCardFile = (data: unknown): data is { readonly [name: string]: unknown } =>
  typeof data === 'object' && data !== null && 'botgarten' in data && data.botgarten === 'card'

/**
 * A card from a file's text, as a project that plays it. Nothing of it is trusted: programs, world and pictures go through
 * the reader of projects, with all its limits.
 * @throws {ProjectError} and nothing else
 */
export function parseCardFile(text: string): Project {
  refuseBigText(text)
  const data = dataIn(text)
  saidOfCard(() => refuseOversize(data))
  if (!isCardFile(data)) throw new ProjectError('notACard', 'This is not a card.')
  const { version, card, name, programs, brains, world, maps, assets, shelf } = data
  if (typeof version === 'number' && version > newest)
    throw new ProjectError('newerCard', `The card has version ${version}; this Botgarten reads ${newest}.`, {
      version,
    })
  if (version !== newest || typeof card !== 'object' || card === null || 'draft' in card)
    throw new ProjectError('notACard', 'This is not a card.')
  const own = maps === undefined ? {} : { maps }
  const chosen = shelf === undefined ? {} : { shelf }
  const parts = { name, ownCard: card, programs, brains, world, assets, ...own, ...chosen }
  const project = saidOfCard(() => parseProject({ botgarten: 3, ...parts }))
  refuseUnfit(project.ownCard!, project)
  return project
}

function dataIn(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    throw new ProjectError('notJson', 'This is not JSON.')
  }
}

/** Its maker may take things out of its world; a card that travels fits it. */
function refuseUnfit(card: OwnCard, { world }: Project): void {
  if (!fitsWorld(card, world)) throw new ProjectError('cardNumbers', messageOf('cardNumbers'))
  if (!bringsPrograms(card, world))
    throw new ProjectError('notACard', 'A robot has a program that the card does not bring.')
}

/** What is broken in it is said of a card. */
function saidOfCard<Result>(read: () => Result): Result {
  try {
    return read()
  } catch (cause) {
    if (!(cause instanceof ProjectError) || cause.reason !== 'notAProject') throw cause
    throw new ProjectError('notACard', cause.message, cause.facts, cause.limit)
  }
}
