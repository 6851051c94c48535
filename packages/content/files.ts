// The catalogue as files, for all that runs in Node: the command line, scripts, tests, benchmarks, the build of the page.
import { globSync } from 'node:fs'
import { join } from 'node:path'
import type { LaneKind, Racer } from '@botgarten/experiments/brain-race'
import type { SenseCage } from '@botgarten/experiments/cages'
import { readMap, type MapFile } from '@botgarten/maps'
import type { Project } from '@botgarten/programs'
import type { Floor, World } from '@botgarten/simulation'
import type { Answers } from './answers/index.ts'
import type { Catalogue } from './catalogue.ts'
import { cardsIn } from './files/cards.ts'
import { coursesIn } from './files/courses.ts'
import { floorsIn } from './files/floors.ts'
import { each, folderAt, idOf, named, once } from './files/folder.ts'
import { itemsIn } from './files/items.ts'
import { questionnairesIn } from './files/questionnaires.ts'
import { sensesIn } from './files/senses.ts'
import { zooIn } from './files/zoo.ts'
import type { CourseFile } from './schema/course.ts'
import type { Topic } from './schema/formTypes.ts'
import { readAlignment } from './schema/alignment.ts'
import { readReferences } from './schema/references.ts'
import { readThings } from './schema/things.ts'

/** The catalogue, and what only they ask who have files. */
export interface ContentFiles extends Catalogue {
  /** Absolute path of what lies below content/. */
  readonly path: (...below: string[]) => string
  /** Paths of all its files but words. */
  readonly filesBelow: () => readonly string[]
  /** Folder of a card below content/: `cards/network/05-friendship`. @throws RangeError where there is no such card */
  readonly cardFolder: (id: string) => string
  /** Names of a card's typical wrong answers, in order. */
  readonly wrongAnswers: (card: string) => readonly string[]
  /** Path of the picture on the front of a card; null for what is no card or has none. */
  readonly pictureOfCard: (id: string) => string | null
  /** A map, read; null where there is none. */
  readonly mapFile: (id: string) => MapFile | null
  /** Folder of an item or a question below content/. */
  readonly itemFolder: (id: string) => string
  /** Names of the pictures beside the text of an item. */
  readonly picturesOf: (item: string) => readonly string[]
  /** Path of the drawing of a cage's map. */
  readonly mapOfCage: (id: string) => string
  /** Names of the cages of the zoo of sensors. */
  readonly senseIds: readonly string[]
  /** A cage of the zoo of sensors as its file says it; null: there is none. */
  readonly senseCage: (id: string) => SenseCage | null
  /** Path of the picture of its animal. */
  readonly pictureOfSenseCage: (id: string) => string
  /** Path of the picture above what a questionnaire asks about a topic. */
  readonly pictureOfTopic: (topic: Topic) => string
  /** Path of the picture of a thing of a set. */
  readonly pictureOf: (set: string, thing: string) => string
  /** Courses on which brains race. */
  readonly courses: readonly CourseFile[]
  /** The brain that drives in a lane of a course where nobody brings another one; null: there is none. */
  readonly racer: (course: string, kind: LaneKind) => Racer | null
  /** The floor of a world whose picture is in content/ or among a project's assets. */
  readonly floorOf: (world: World, assets?: Project['assets']) => Floor
}

/** What lies in a folder that is built like content/. @throws where a file breaks the rules of its kind, when it is asked for */
export function contentIn(root: string): ContentFiles {
  const folder = folderAt(root)
  const cards = cardsIn(folder)
  const items = itemsIn(folder)
  const zoo = zooIn(folder)
  const senses = sensesIn(folder)
  const courses = coursesIn(folder, cards.program)
  const questionnaires = questionnairesIn(folder)
  const maps = once(() => folder.foldersWith('maps/*/map.svg').map(idOf))
  const map = (id: string) => (maps().includes(id) ? folder.text('maps', id, 'map.svg') : null)
  const mapFile = each((id) => {
    const svg = map(id)
    return svg === null ? null : readMap(svg).map
  })
  const stations = once(() =>
    Object.fromEntries(maps().map((id) => [id, mapFile(id)?.map.actions.length ?? 0])),
  )
  const ends = once(() =>
    Object.fromEntries(
      maps().map((id) => {
        const map = mapFile(id)
        const { start = 0, goal = (map?.stations.length ?? 1) - 1 } = map ?? {}
        return [id, [start, goal] as const]
      }),
    ),
  )
  const setFolders = once(() => folder.foldersWith('things/*/things.json'))
  const sets = once(() => setFolders().map((one) => named(one, readThings(folder.json(one, 'things.json')))))

  return {
    get languages() {
      return folder.languages()
    },
    get cards() {
      return cards.heads()
    },
    get worlds() {
      return cards.worlds()
    },
    get maps() {
      return maps()
    },
    get stations() {
      return stations()
    },
    get ends() {
      return ends()
    },
    get drawn() {
      return maps().filter((id) => !mapFile(id)?.grid)
    },
    get sets() {
      return sets()
    },
    get cages() {
      return zoo.cages()
    },
    get senseCages() {
      return senses.cages()
    },
    get senseIds() {
      return senses.ids()
    },
    get courses() {
      return courses.courses()
    },
    get forms() {
      return questionnaires.forms()
    },
    get items() {
      return items.items()
    },
    get packs() {
      return items.packs()
    },
    get questions() {
      return items.questions()
    },
    ...{ map, mapFile, floorOf: floorsIn(folder), path: folder.path, cardFolder: cards.folderOf },
    ...{ card: cards.card, program: cards.program, world: cards.world },
    racer: courses.racer,
    ...{ pictureOfCard: cards.pictureOfCard, mapOfCage: zoo.mapOf },
    ...{ senseCage: senses.cage, pictureOfSenseCage: senses.pictureOf },
    pictureOfTopic: questionnaires.pictureOfTopic,
    filesBelow: once(() =>
      globSync('{cards,courses,free-lab,maps,materials,questionnaires,senses,things,worlds,zoo}/**/*.*', {
        cwd: root,
      }).map((file) => folder.path(file)),
    ),
    ...{
      freeLab: cards.freeLab,
      goals: cards.goals,
      newBlocks: cards.newBlocks,
      wrongAnswers: cards.wrongAnswers,
    },
    ...{ itemTexts: items.itemTexts, itemFolder: items.folderOf, picturesOf: items.picturesOf },
    pictureOf: (set, thing) =>
      folder.path(
        setFolders().find((one) => idOf(one) === set)!,
        `${thing}.svg`,
      ),
    answers: () => folder.json('materials/answers.json') as Answers,
    alignment: () => readAlignment(folder.json('materials/alignment.json')),
    references: () => readReferences(folder.json('materials/references.json')),
  }
}

/** The product's own content/. */
export const content: ContentFiles = contentIn(join(import.meta.dirname, '../../content'))
