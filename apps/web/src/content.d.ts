declare module '*.md' {
  import type { CardText } from '@botgarten/materials'
  const text: CardText
  export default text
}
