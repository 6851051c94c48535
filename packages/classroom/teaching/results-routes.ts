import { pupilsOf } from '../joining/pupils-store.ts'
import type { CardOfClass, Ports } from '../ports.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { csv } from './csv.ts'
import { resultsOf } from './results-store.ts'
import { cardsIn } from './shown.ts'

interface Row {
  readonly id: string
  readonly nickname: string
  /** From how many start places of each card that was begun. */
  readonly done: { readonly [card: string]: number }
}

async function rowsOf({ database: { db } }: Ports, classId: string): Promise<Row[]> {
  const results = await resultsOf(db, classId)
  return (await pupilsOf(db, classId)).map(({ id, nickname }) => {
    const own = results.filter(({ pupil }) => pupil === id)
    return { id, nickname, done: Object.fromEntries(own.map(({ card, done }) => [card, done])) }
  })
}

/** Who has done which card. Cards that the class has begun and that are no more come last. */
async function results({ ports, who }: Call<undefined>): Promise<Answer> {
  const cards = (await ports.cards()).map(({ id, starts }) => ({ id, starts }))
  return { body: { cards, free: cardsIn(who.class!.cards), pupils: await rowsOf(ports, who.class!.id) } }
}

const cellOf = ({ id, starts }: CardOfClass, { done }: Row): string =>
  done[id] === undefined ? '' : `${done[id]}/${starts}`

async function asCsv({ ports, who, query }: Call<undefined>): Promise<Response> {
  const language = query.get('lang') === 'de' ? 'de' : 'en'
  const cards = await ports.cards()
  const head = ['', ...cards.map(({ id, title }) => title[language] ?? title['en'] ?? id)]
  const rows = (await rowsOf(ports, who.class!.id)).map((row) => [
    row.nickname,
    ...cards.map((card) => cellOf(card, row)),
  ])
  const headers = {
    'content-type': 'text/csv; charset=utf-8',
    'content-disposition': 'attachment; filename="botgarten.csv"',
  }
  return new Response(csv([head, ...rows], language), { headers })
}

export const resultRoutes: readonly Route[] = [
  route('GET', '/classes/:class/results', ['owner'], results),
  route('GET', '/classes/:class/results.csv', ['owner'], asCsv),
]
