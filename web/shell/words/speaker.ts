// What another language than English needs, loaded with its catalogue: messages with plurals and numbers, and for
// writing from the right the forms and the order in which the canvas draws letters.
import { ArabicShaper } from 'arabic-persian-reshaper';
import bidiFactory from 'bidi-js';
import { IntlMessageFormat } from 'intl-messageformat';

/** What a text names in braces. */
export type Args = Readonly<Record<string, string | number>>;

/** English text → the message in a language, in ICU syntax. */
export type Catalogue = Readonly<Record<string, string>>;

export interface Speaker {
  /** Null: the catalogue has no such text. */
  translated(english: string, args: Args): string | null;
  drawn(text: string): string;
}

const kArabic = /[\u0600-\u06ff]/;

/** Joined letters from the left to the right, as they lie on the screen. */
function visual(text: string): string {
  if (!kArabic.test(text)) return text;
  const bidi = bidiFactory();
  const shaped = ArabicShaper.convertArabic(text);
  return bidi.getReorderedString(shaped, bidi.getEmbeddingLevels(shaped, 'rtl'));
}

/** The message with its plain numbers in the way of the language: "8,6" in German. */
function withNumbers(message: string, args: Args): string {
  return message.replace(/\{(\w+)\}/g, (all, name: string) =>
    typeof args[name] === 'number' ? `{${name}, number, ::group-off .###}` : all,
  );
}

export function speakerOf(id: string, catalogue: Catalogue): Speaker {
  const messages = new Map<string, IntlMessageFormat>();
  // Digits as on the keyboard that they are typed with.
  const locale = `${id}-u-nu-latn`;
  return {
    translated(english, args) {
      const message = catalogue[english];
      if (message === undefined) return null;
      if (!message.includes('{')) return message;
      let format = messages.get(english);
      if (!format) {
        format = new IntlMessageFormat(withNumbers(message, args), locale, {}, { ignoreTag: true });
        messages.set(english, format);
      }
      try {
        return String(format.format({ ...args }));
      } catch (thrown) {
        console.warn(thrown);
        return null;
      }
    },
    drawn: id === 'ar' ? visual : (text) => text,
  };
}
