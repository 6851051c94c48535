import { ownName } from './account.ts'

/** What a tab tells the others about a project. */
export type News =
  | {
      readonly kind: 'saved'
      readonly id: string
      readonly revision: number
      readonly name?: string | undefined
    }
  | { readonly kind: 'gone'; readonly id: string }

type Message = News | { readonly kind: 'who' } | { readonly kind: 'open' | 'closed'; readonly id: string }

const newChannel = () =>
  typeof BroadcastChannel === 'undefined' ? null : new BroadcastChannel(ownName('botgarten-projects'))
const channel = newChannel()

export const announce = (message: News): void => channel?.postMessage(message)

function listen(heard: (message: Message) => void): () => void {
  const listener = ({ data }: MessageEvent<Message>) => heard(data)
  channel?.addEventListener('message', listener)
  return () => channel?.removeEventListener('message', listener)
}

/** Calls back when another tab has changed a project that is open here. Returns how to stop. */
export function whenChangedElsewhere(id: string, heard: (news: News) => void): () => void {
  channel?.postMessage({ kind: 'open', id })
  const stop = listen((message) => {
    if (message.kind === 'who') channel?.postMessage({ kind: 'open', id })
    else if ((message.kind === 'saved' || message.kind === 'gone') && message.id === id) heard(message)
  })
  return () => {
    stop()
    channel?.postMessage({ kind: 'closed', id })
  }
}

interface Watcher {
  open(id: string): void
  closed(id: string): void
  changed(): void
}

/** Calls back for every project that another tab has open, now and later, and for every change. Returns how to stop. */
export function watchTabs(heard: Watcher): () => void {
  const stop = listen((message) => {
    if (message.kind === 'open') heard.open(message.id)
    else if (message.kind === 'closed') heard.closed(message.id)
    else if (message.kind !== 'who') heard.changed()
  })
  channel?.postMessage({ kind: 'who' })
  return stop
}

/** Calls back when a project was saved or thrown away, in this tab or another. Returns how to stop. */
export function whenAnythingChanges(heard: () => void): () => void {
  // A channel gets the messages of others, those of its own tab too.
  const own = newChannel()
  const listener = ({ data }: MessageEvent<Message>) => {
    if (data.kind === 'saved' || data.kind === 'gone') heard()
  }
  own?.addEventListener('message', listener)
  return () => own?.close()
}
