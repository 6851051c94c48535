import type { Card, CardText, Markdown } from '@botgarten/content'
import type { LoadedCard } from '@botgarten/content/catalogue'
import { languagesOf, type OwnCard, type OwnCardText, type Project } from '@botgarten/programs/project'
import type { Obstacle, World } from '@botgarten/simulation'
import { thingName } from '#content/thing-name.ts'
import { m } from '#words/message.ts'
import { ownCardId } from './cards.ts'

type Need = Card['needs'][number]

/** A card that somebody has made, as the lab shows every card. What its checks are called is said in the language of now. */
export function loadedFrom({
  ownCard,
  programs,
  brains,
  world,
  assets,
}: Project & { ownCard: OwnCard }): LoadedCard {
  const playground = JSON.stringify(programs).includes('"ai_neural_network"') ? 'network' : 'drive'
  const { starts, checks, minutes, grades } = ownCard
  const whole = languagesOf(ownCard)
  const textOf = (language: 'de' | 'en') => ownCard.text[whole.includes(language) ? language : whole[0]!]!
  const labels = () => Object.fromEntries(checks.map((check) => [check.id, goalOf(check, world)]))
  return {
    card: {
      ...{
        id: ownCardId,
        code: '',
        playground,
        grades,
        minutes,
        starts,
        checks,
        world: ownCardId,
        next: null,
      },
      needs: needsOf(ownCard, world, programs),
    },
    bed: playground,
    world,
    start: { programs, brains },
    assets,
    text: { de: wordsOf(textOf('de'), labels), en: wordsOf(textOf('en'), labels) },
  }
}

const wordsOf = ({ title, story, task, hints }: OwnCardText, labels: () => CardText['checks']): CardText => ({
  ...{ title, story: paragraphs(story), hints: hints.map(paragraphs), further: [] },
  goal: { call: title, sentence: task },
  get checks() {
    return labels()
  },
})

/** Plain text as paragraphs; an empty line parts them. */
export const paragraphs = (text: string): Markdown =>
  text
    .split(/\n\s*\n/)
    .filter((part) => part.trim() !== '')
    .map((part) => ({ type: 'paragraph', children: [{ type: 'text', value: part.trim() }] }))

const colours: { readonly [hex: string]: () => string } = {
  '#000000': m['choice.black'],
  '#0057A6': m['choice.blue'],
  '#00642E': m['choice.green'],
  '#F7D117': m['choice.yellow'],
  '#B30006': m['choice.red'],
  '#FFFFFF': m['choice.white'],
  '#532115': m['choice.brown'],
}
/** A colour that sensors tell apart, by its name. */
export const colourName = (hex: string): string => colours[hex]?.() ?? hex

const lamps: { readonly [lamp: string]: () => string } = {
  green: m['choice.green'],
  orange: m['choice.orange'],
  red: m['choice.red'],
}
/** '' is dark. */
export const lampName = (lamp: string): string => (lamps[lamp] ?? m['card.dark'])()

type Check = OwnCard['checks'][number]

/** Where several things look alike, their places tell them apart. */
export function nameOfThing(id: string, { obstacles }: Pick<World, 'obstacles'>): string {
  const thing = obstacles.find((one) => one.id === id)
  if (!thing) return m['world.thing.plain']()
  const name = thingName(thing)
  const alike = obstacles.filter((one: Obstacle) => thingName(one) === name)
  return alike.length > 1 ? `${name} ${alike.indexOf(thing) + 1}` : name
}

/** What is to be seen, in few words, as on the cards of the house. */
export function goalOf({ kind, numbers, seconds }: Check, world: Pick<World, 'obstacles'>): string {
  const of = (name: string) => String(numbers[name] ?? '')
  const thing = nameOfThing(of('obstacle'), world)
  const colour = colourName(of('colour'))
  const facts = { ...numbers, seconds, thing, colour, lamp: lampName(of('lamp')) }
  const count = of(kind === 'laps' ? 'gates' : 'points').split(',').length
  return m[`card.goal.${kind as 'near'}`]({ ...facts, count } as never)
}

function needsOf(
  { checks }: OwnCard,
  { robots, obstacles }: World,
  programs: Project['programs'],
): readonly Need[] {
  const sensors = Object.values(robots[0]!.config.sensors).map(({ kind }) => kind)
  const asks = (kind: string) => checks.some((check) => check.kind === kind)
  const written = JSON.stringify([programs, checks]).toLowerCase()
  const uses = (word: string) => written.includes(word)
  const isWall = obstacles.some(({ look }) => look === 'wall')
  const isSquare = obstacles.some(({ look, colour }) => look !== 'wall' && colour === '#0057A6')
  const needs: readonly (readonly [Need, boolean])[] = [
    ['distanceSensors', sensors.filter((kind) => kind === 'ultrasonic').length > 1 && uses('ultrasonic')],
    ['colourSensor', sensors.includes('colour') && uses('colour')],
    ['motors', true],
    ['lamp', asks('led')],
    ['speaker', asks('sings')],
    ['display', asks('says') || asks('silent')],
    ['wall', isWall],
    ['blueSquare', isSquare],
  ]
  return needs.filter(([, is]) => is).map(([need]) => need)
}
