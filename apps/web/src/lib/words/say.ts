// Not `messages.js`: it would bring a second table of all messages.
import * as messages from './generated/messages/_index.js'

type Message = (facts: { readonly [name: string]: string | number }) => string

/**
 * Says a message whose key is data (a check's, a finding's), in the language of now. An unknown key comes back as it is.
 * Brings every message along: not for pages that must stay small.
 */
export function say(key: string, facts: { readonly [name: string]: string | number } = {}): string {
  const all = messages as unknown as { readonly [key: string]: Message | undefined }
  return all[key]?.(facts) ?? key
}
