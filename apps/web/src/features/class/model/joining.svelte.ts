import { setAccount } from '#storage/account.ts'
import { pictures, type Picture } from '@botgarten/classroom/pictures'
import * as v from 'valibot'
import { codeInLink, codeLength, codeOf, fitsAsNickname, isComplete, wordsIn } from './code.ts'
import { arrive } from './here.ts'
import { patient, type Wait } from './patient.ts'
import { read, type Ask, type Reply } from '#storage/ask.ts'

const picture = v.picklist(pictures)
const looked = v.object({ name: v.string() })
const returned = v.object({ id: v.string(), class: v.string(), nickname: v.string() })
const joined = v.object({ ...returned.entries, pictures: v.tuple([picture, picture, picture]) })

/** Why it did not work: a message of `class.refused`, and minutes to wait where there are some. */
export interface Refused {
  readonly code: string
  readonly minutes: number
}

const known = [
  ...['noOpenClass', 'nickname', 'nicknameTaken', 'wrongPictures'],
  ...['nicknameLocked', 'tooManyTries', 'classHasAll'],
]

export function refusedBy(reply: Reply): Refused {
  if (reply.kind !== 'refused') return { code: 'away', minutes: 0 }
  const { code, facts } = reply
  return {
    code: known.includes(code) ? code : 'other',
    minutes: Math.max(1, Math.ceil((facts.seconds ?? 0) / 60)),
  }
}

/** `code`: code and nickname are typed · `given`: a newcomer is shown three pictures · `pictures`: who comes back shows them */
type Step = 'code' | 'given' | 'pictures'

/** A child at the door of its class. */
export class Joining {
  readonly #ask: Ask
  /** The words of the code as they are typed. */
  words = $state(Array<string>(codeLength).fill(''))
  nickname = $state('')
  /** It has been here before. */
  returns = $state(false)
  #step = $state<Step>('code')
  #className = $state<string | null>(null)
  #refused = $state.raw<Refused | null>(null)
  #busy = $state(false)
  #given = $state.raw<readonly Picture[]>([])
  shown = $state.raw<readonly Picture[]>([])
  /** The code that was asked for last: it is not asked again. */
  #asked = ''

  /** @param wait waits, for a number of seconds, before the next request */
  constructor(ask: Ask, wait?: Wait) {
    this.#ask = patient(ask, {
      waits: () => void (this.#refused = { code: 'waits', minutes: 0 }),
      isWanted: () => codeOf(this.words) === this.#asked,
      wait,
    })
  }

  get step() {
    return this.#step
  }
  /** Name of the class, once its code is right. */
  get className() {
    return this.#className
  }
  get refused() {
    return this.#refused
  }
  get busy() {
    return this.#busy
  }
  /** The pictures that a newcomer is given. */
  get given() {
    return this.#given
  }
  /** All of the code is typed. */
  get isComplete(): boolean {
    return isComplete(this.words)
  }
  get canGoOn(): boolean {
    return this.#className !== null && fitsAsNickname(this.nickname)
  }

  /** Takes the code from a link. @returns whether it held one */
  takeLink(hash: string): boolean {
    const words = codeInLink(hash)
    if (words) this.words = this.words.map((_, at) => words[at] ?? '')
    return words !== null
  }

  /** Types into the field of a word; several words at once fill the fields from there on. @returns the field to go on in */
  type(at: number, text: string): number {
    const words = wordsIn(text)
    const ends = /[^\p{L}]$/u.test(text) && words.length > 0
    this.words = this.words.map((word, index) =>
      index < at ? word : (words[index - at] ?? (index === at ? '' : word)),
    )
    return Math.min(codeLength - 1, at + Math.max(0, words.length - 1) + (ends ? 1 : 0))
  }

  async #asking(act: () => Promise<void>): Promise<void> {
    if (this.#busy) return
    this.#busy = true
    this.#refused = null
    await act()
    if (this.refused?.code === 'waits') this.#refused = null
    this.#busy = false
  }

  /** Asks whose code this is, once it is typed. */
  async look(again = false): Promise<void> {
    const code = codeOf(this.words)
    if (code === null) this.#className = null
    // The request that is under way looks up what was typed meanwhile.
    if (code === null || this.#busy || (code === this.#asked && !again)) return
    await this.#asking(async () => {
      this.#asked = code
      const reply = await this.#ask('POST', '/look', { code })
      this.#className = read(looked, reply)?.name ?? null
      if (this.#className === null) this.#refuse(reply)
    })
    // Something else was typed meanwhile.
    if (codeOf(this.words) !== code) await this.look()
  }

  #refuse(reply: Reply): void {
    this.#refused = refusedBy(reply)
    // It may be right the next time.
    if (this.#refused.code !== 'noOpenClass') this.#asked = ''
  }

  /** A newcomer joins; who comes back is asked for the pictures. */
  async goOn(): Promise<void> {
    if (!this.canGoOn) return
    if (this.returns) this.#step = 'pictures'
    else await this.#asking(() => this.#join())
  }

  async #join(): Promise<void> {
    const reply = await this.#ask('POST', '/join', { code: codeOf(this.words), nickname: this.nickname })
    const pupil = read(joined, reply)
    if (!pupil) return this.#refuse(reply)
    this.#given = pupil.pictures
    if (this.#keep(pupil, 'new')) this.#step = 'given'
  }

  /** From the next page on this device is the pupil's. */
  #keep({ id, class: of, nickname }: v.InferOutput<typeof returned>, as: 'new' | 'back'): boolean {
    try {
      setAccount({ pupil: id, class: of, nickname, className: this.#className ?? '' })
      arrive(id, as)
      return true
    } catch {
      this.#refused = { code: 'notHere', minutes: 0 }
      return false
    }
  }

  /** Taps one picture after the other; the third one sends. @returns whether the child is back */
  async show(one: Picture): Promise<boolean> {
    if (this.#busy || this.shown.includes(one)) return false
    this.shown = [...this.shown, one]
    if (this.shown.length < 3) return false
    let isBack = false
    await this.#asking(async () => {
      const { nickname, shown: pictures } = this
      const reply = await this.#ask('POST', '/return', { code: codeOf(this.words), nickname, pictures })
      const pupil = read(returned, reply)
      if (pupil) isBack = this.#keep(pupil, 'back')
      else this.#refuse(reply)
    })
    if (!isBack) this.shown = []
    return isBack
  }

  /** Back to code and nickname. */
  goBack(): void {
    this.#step = 'code'
    this.#refused = null
    this.shown = []
  }
}
