import { execFileSync, spawnSync } from 'node:child_process'
import { mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { startNode } from '@botgarten/server/rehearsal'
import { Trouble } from '../prepare/run.mjs'
import { goOn, type Card, type Guest } from './guest.ts'
import { mib, partitions, place, sector } from './partitions.ts'
import { lostOf, pupilOf, type Pupil } from './pupils.ts'

/** A lesson in a guest: what a part of the try begins with. */
export interface Lesson {
  readonly card: Card
  readonly guest: Guest
  readonly pupils: readonly Pupil[]
}

export const siteOf = ({ port }: Card): string => `http://127.0.0.1:${port}`

export const copyCard = (from: string, to: string): void =>
  void execFileSync('cp', ['--sparse=always', from, to])

const namesIn = (folder: string) => ({
  file: join(folder, 'lesson.img'),
  memory: join(folder, 'lesson.memory'),
  children: join(folder, 'lesson.json'),
})

/** Keeps a lesson as it is: the guest ends, and parts of the try go on from here, each with a card of its own. */
export async function keepLesson({ card, guest, pupils }: Lesson, folder: string): Promise<void> {
  const { file, memory, children } = namesIn(folder)
  await guest.freeze(memory)
  copyCard(card.file, file)
  const kept = pupils.map(({ client, ...rest }) => ({ ...rest, cookies: [...client.cookies] }))
  writeFileSync(children, JSON.stringify(kept))
}

/**
 * The kept lesson, running again at its own time: children are signed in for a lesson, and an emulated Pi takes hours.
 *
 * @param name of the part that it is for
 */
export async function lessonFor(name: string, port: number, folder: string): Promise<Lesson> {
  const { file, memory, children } = namesIn(folder)
  const clock = statSync(children).mtimeMs
  const card = { file: join(folder, `${name}.img`), work: join(folder, name), port, clock }
  copyCard(file, card.file)
  const kept = JSON.parse(readFileSync(children, 'utf8')) as Parameters<typeof pupilOf>[1][]
  return { card, guest: await goOn(card, memory), pupils: kept.map((one) => pupilOf(siteOf(card), one)) }
}

const dataAt = (place(partitions)[3]!.start * sector) / mib

/** Takes the lab's data out of a card whose plug was pulled, by the journal of its file system. */
function dataOf({ file, work }: Card): string {
  const [partition, folder] = [join(work, 'data.img'), join(work, 'data')]
  const copy = [`if=${file}`, `of=${partition}`, 'bs=1M', `skip=${dataAt}`, 'conv=sparse', 'status=none']
  execFileSync('dd', copy)
  const { status, stdout } = spawnSync('e2fsck', ['-f', '-p', partition], { encoding: 'utf8' })
  // 1: put right, as after any cut.
  if (status === null || status > 1) throw new Trouble(`The file system of the data is broken.\n${stdout}`)
  rmSync(folder, { recursive: true, force: true })
  mkdirSync(folder)
  execFileSync('debugfs', ['-R', `rdump /lab ${folder}`, partition], { stdio: 'ignore' })
  return join(folder, 'lab')
}

/** Options of Node that put the clock back. @param ms since 1970; now, for the process that is started */
const atTime = (ms: number) => [
  '--import',
  `data:text/javascript,const { now } = Date, back = ${Math.round(Date.now() - ms)}; Date.now = () => now() - back`,
]

/** How many acknowledged saves are not on a card whose plug was pulled, read by the lab on this machine. */
export async function lostOnCard({ card, pupils }: Lesson): Promise<number> {
  const node = await startNode({
    data: dataOf(card),
    port: card.port,
    flags: card.clock === undefined ? [] : atTime(card.clock),
  })
  try {
    const lost = await Promise.all(pupils.map(lostOf))
    return lost.reduce((sum, one) => sum + one, 0)
  } finally {
    await node.kill()
  }
}
