import type { Live } from './tiles.ts'

/** Messages between the nodes of a server. A node that misses some reads the state again. */
export type Message =
  | { readonly kind: 'tiles'; readonly class: string; readonly tiles: readonly { id: string; live: Live }[] }
  /** Something in the database is another now: for these pupils, or for all of the class. */
  | { readonly kind: 'changed'; readonly class: string; readonly pupils: readonly string[] | null }
  | {
      readonly kind: 'attention'
      readonly class: string
      /** Ms from now on; 0: it ends. */
      readonly left: number
    }
  | {
      readonly kind: 'inside'
      readonly class: string
      readonly pupil: string
      readonly by: string | null
      /** Ms from now on; 0: it ends. */
      readonly left: number
    }
  /** A short event for the pages of one pupil; null: of all. */
  | {
      readonly kind: 'event'
      readonly class: string
      readonly pupil: string | null
      readonly event: string
      readonly data: unknown
    }
  /** Streams end: of one pupil, of all pupils, of a teacher, or of all in the class. */
  | { readonly kind: 'end'; readonly class: string | null; readonly who: Ended; readonly reason: EndReason }

export type Ended =
  { readonly pupil: string } | { readonly teacher: string } | 'pupils' | 'substitutes' | 'everybody'
/** `again`: the stream was too long or too slow; it is opened again. */
export type EndReason = 'closed' | 'removed' | 'signedOut' | 'ended' | 'again'

export interface Bus {
  send(message: Message): void
  /** @param hear gets what other nodes have sent @param missed some of it may have been lost */
  listen(hear: (message: Message) => void, missed: () => void): void
  close(): Promise<void>
}

/** Of a server with one node, which has no others. */
export const noBus: Bus = { send: () => {}, listen: () => {}, close: () => Promise.resolve() }
