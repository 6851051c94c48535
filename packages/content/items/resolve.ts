import type { Embed } from '../schema/embed.ts'
import type { ItemText } from '../schema/itemTypes.ts'
import { nodesOf } from './walk.ts'

/** What there is to be shown, by id: the catalogue as an item can name it. */
export interface Nameable {
  readonly items: ReadonlySet<string>
  /** Programs of each card, as `start`, `solution`, `wrong/<name>`, those with a network apart; and its start poses. */
  readonly cards: ReadonlyMap<string, NameableCard>
  /** Roads of each map, as `3-2`. */
  readonly maps: ReadonlyMap<string, { readonly stations: number; readonly roads: ReadonlySet<string> }>
  readonly worlds: ReadonlySet<string>
  readonly sets: ReadonlySet<string>
  readonly blocks: ReadonlySet<string>
  readonly courses: ReadonlySet<string>
  /** Cages of the zoo of sensors. */
  readonly cages: ReadonlySet<string>
  /** Questions of each module. */
  readonly questions: ReadonlyMap<number, ReadonlySet<string>>
}

export interface NameableCard {
  readonly playground: string
  readonly starts: number
  readonly files: ReadonlySet<string>
  readonly nets: ReadonlySet<string>
  /** Ids of the blocks in each program. */
  readonly blocks: ReadonlyMap<string, ReadonlySet<string>>
}

/** What an item names and is not there, a sentence each. `pictures`: files beside the text. */
export function missingIn(
  text: ItemText,
  nameable: Nameable,
  pictures: ReadonlySet<string>,
): readonly string[] {
  return [...nodesOf(text)].flatMap((node) => {
    if (node.type === 'embed') return missing(node.embed, nameable)
    if (node.type === 'link') return missingTarget(node.href, nameable)
    if (node.type !== 'image') return []
    const silent = node.alt.trim() === '' ? [`The picture "${node.file}" has no words.`] : []
    return pictures.has(node.file) ? silent : [...silent, `There is no picture "${node.file}".`]
  })
}

const unless = (there: boolean | undefined, sentence: string) => (there ? [] : [sentence])

function missing(embed: Embed, nameable: Nameable): readonly string[] {
  switch (embed.kind) {
    case 'card':
      return unless(nameable.cards.has(embed.id), `There is no card "${embed.id}".`)
    case 'robot':
      return unless(nameable.cards.has(embed.card), `There is no card "${embed.card}".`)
    case 'knobs':
    case 'net':
      return missingNet(embed, nameable)
    case 'program':
      return missingPart(embed, nameable)
    case 'live':
      return missingFile(embed, nameable)
    case 'way':
    case 'tries':
    case 'trials':
      return missingWay(embed, nameable)
    case 'scene':
      return missingScene(embed, nameable)
    case 'map':
      return missingOnMap(embed, nameable)
    case 'world':
      return unless(nameable.worlds.has(embed.id), `There is no world "${embed.id}".`)
    case 'sort':
    case 'things':
      return unless(nameable.sets.has(embed.set), `There is no set "${embed.set}".`)
    case 'race':
      return unless(nameable.courses.has(embed.course), `There is no course "${embed.course}".`)
    case 'senses':
      return (embed.only ?? []).flatMap((one) =>
        unless(nameable.cages.has(one), `There is no cage "${one}".`),
      )
    case 'block':
      return unless(nameable.blocks.has(embed.type), `There is no block "${embed.type}".`)
    case 'qr':
      return missingTarget(embed.to, nameable)
    case 'questions':
      return missingQuestions(embed, nameable)
    default:
      return []
  }
}

function missingQuestions(
  { module, only = [] }: Extract<Embed, { kind: 'questions' }>,
  { questions }: Nameable,
): readonly string[] {
  const there = questions.get(module)
  if (!there) return [`Module ${module} has no questions.`]
  return only.filter((id) => !there.has(id)).map((id) => `Module ${module} has no question "${id}".`)
}

function missingTarget(target: string, { items, cards }: Nameable): readonly string[] {
  const [kind, id] = target.split(':') as [string, string]
  if (kind === 'item') return unless(items.has(id), `There is no item "${id}".`)
  if (kind === 'card') return unless(cards.has(id), `There is no card "${id}".`)
  return []
}

function missingFile({ card, file }: { card: string; file: string }, { cards }: Nameable): readonly string[] {
  const there = cards.get(card)
  if (!there) return [`There is no card "${card}".`]
  return unless(there.files.has(file), `The card "${card}" has no "${file}".`)
}

function missingPart(named: Extract<Embed, { kind: 'program' }>, nameable: Nameable): readonly string[] {
  const none = missingFile(named, nameable)
  if (none.length > 0) return none
  const blocks = nameable.cards.get(named.card)!.blocks.get(named.file)
  return [named.only, named.fold].flatMap((id) =>
    unless(id === undefined || blocks?.has(id), `"${named.file}" of "${named.card}" has no block "${id}".`),
  )
}

function missingNet(named: { card: string; file: string }, nameable: Nameable): readonly string[] {
  const none = missingFile(named, nameable)
  if (none.length > 0) return none
  const { nets } = nameable.cards.get(named.card)!
  return unless(nets.has(named.file), `"${named.file}" of "${named.card}" has no network.`)
}

function missingWay({ card }: { card: string }, { cards }: Nameable): readonly string[] {
  const there = cards.get(card)
  if (!there) return [`There is no card "${card}".`]
  return unless(there.playground === 'q-learning', `The card "${card}" learns no way.`)
}

function missingScene(
  { card, start }: { card: string; start: number },
  { cards }: Nameable,
): readonly string[] {
  const there = cards.get(card)
  if (!there) return [`There is no card "${card}".`]
  return unless(start < there.starts, `The card "${card}" has no start pose ${start}.`)
}

function missingOnMap(embed: Extract<Embed, { kind: 'map' }>, { maps }: Nameable): readonly string[] {
  const map = maps.get(embed.id)
  if (!map) return [`There is no map "${embed.id}".`]
  const stations = [embed.start, embed.goal].filter((station) => station !== undefined)
  return [
    ...stations.flatMap((one) => unless(one < map.stations, `"${embed.id}" has no station ${one}.`)),
    ...(embed.closed ?? []).flatMap((road) =>
      unless(map.roads.has(road), `"${embed.id}" has no road ${road}.`),
    ),
  ]
}
