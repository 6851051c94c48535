const named: { readonly [sign: string]: string } = { '\\': '\\\\', '\n': '\\n', '\r': '\\r', '\t': '\\t' }

const count = (text: string, sign: string) => text.split(sign).length - 1

/** A text as black writes it: in double quotes, or in single ones where that saves backslashes. */
export function quote(text: string): string {
  const mark = count(text, '"') > count(text, "'") ? "'" : '"'
  const inside = text.replace(/[\\\p{Cc}\u2028\u2029\p{Cs}]/gu, (sign) => named[sign] ?? escaped(sign))
  return mark + inside.replaceAll(mark, `\\${mark}`) + mark
}

function escaped(sign: string): string {
  const code = sign.charCodeAt(0)
  return code < 256 ? `\\x${code.toString(16).padStart(2, '0')}` : `\\u${code.toString(16).padStart(4, '0')}`
}
